// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "curve/output/curved_mesh.h"
#include "mesh/io/io_formats.h"

/// What files of curved meshes hold.
namespace mq::curve {

inline std::string to_msh(const CurvedMesh& mesh) {
    return mesh::text_of(mesh::to_msh, exported(mesh));
}

inline std::string to_vtu(const CurvedMesh& mesh) {
    return mesh::text_of(mesh::to_vtu, exported(mesh));
}

}  // namespace mq::curve

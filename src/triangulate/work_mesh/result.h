// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/quality/mesh_report.h"
#include "mesh/triangle_mesh.h"

namespace mq::triangulate {

/// The return value of triangulate().
struct Result {
    mesh::TriangleMesh mesh;
    mesh::MeshReport report;
};

}  // namespace mq::triangulate

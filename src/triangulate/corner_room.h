// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "mesh/surface_mesh.h"

namespace mq::triangulate {

/// How much room there is around the CAD nodes of S_C.
struct CornerRoom {
    std::vector<double> innermost;  ///< by vertex: of a CAD node the radius of the innermost shell, mm; else 0
    std::vector<int> narrow_nodes;  ///< vertices of the nodes that have a narrow corner, ascending
};

CornerRoom measure_room(const mesh::SurfaceMesh& mesh);

}  // namespace mq::triangulate

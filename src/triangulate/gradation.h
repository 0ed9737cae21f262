// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "mesh/surface_mesh.h"

namespace mq::triangulate {

/// Sizes that grow slowly: at every vertex the least of its own size, the mean length of its edges, and of what other
/// sizes grow to on the way to it along the edges: by `growth` - 1 mm a mm. Time O(n log n).
/// (Borouchaki, Hecht, Frey 1998: mesh gradation control, the h-variation.)
/// @return by vertex, mm; infinite for a vertex without edges
std::vector<double> graded_sizes(const mesh::SurfaceMesh& mesh, double growth);

}  // namespace mq::triangulate

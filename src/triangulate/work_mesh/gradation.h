// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Returns sizes that grow slowly: at every vertex the least of its own size, the mean length of its edges, and of the
/// sizes of other vertices plus `growth` - 1 mm per mm of the path to it along the edges. Time O(n log n).
/// (Borouchaki, Hecht, Frey 1998: mesh gradation control, the h-variation.)
/// @return by vertex, mm; infinite for a vertex without edges
std::vector<double> graded_sizes(const ClassifiedMesh& mesh, double growth);

}  // namespace mq::triangulate

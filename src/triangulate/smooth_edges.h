// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/edge_bounds.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Which CAD edges the surface crosses smoothly, as 0 or 1 by edge: the normals of the two faces beside it differ by
/// less than `feature_angle` degrees all along, measured at nine points of the edge at least, and at the ends and the
/// middles of all its segments.
///
/// Never among them: edges with one face or more than two, seams and slits (both sides on one face, where (u, v)
/// jumps), edges between faces that do not bound the same volumes from the same side, and edges that `sizes` names,
/// or whose ends or faces it names: there somebody wants edges of his own.
std::vector<char> smooth_edges(Workspace& work, double feature_angle, const std::vector<LocalSize>& sizes);

}  // namespace mq::triangulate

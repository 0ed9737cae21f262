// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/work_mesh/size_bounds.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Returns which CAD edges the surface crosses smoothly, as 0 or 1 by edge: the normals of the two faces beside the
/// edge differ by less than `feature_angle` degrees along all of it, measured at nine points of the edge or more, and
/// at the ends and the middles of all its segments.
///
/// Excluded are: edges without a segment in the mesh, edges with one face or more than two, seams and slits (both sides
/// on one face, where (u, v) jumps), edges between faces that do not bound the same volumes from the same side, and
/// edges that `sizes` names, or whose ends or faces it names: a local size needs its own edges.
std::vector<char> smooth_edges(Workspace& work, double feature_angle, const std::vector<LocalSize>& sizes);

}  // namespace mq::triangulate

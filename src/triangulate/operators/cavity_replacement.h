// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "triangulate/operators/cavity.h"
#include "triangulate/work_mesh/size_bounds.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Whether the spokes of a fan satisfy the bounds on lengths and on the turn of normals. `apex_site` as for fan_angle.
bool within_bounds(const Workspace& work, const Sizing& sizing, const Cavity& disc, const Corner& apex, int apex_site);

/// Withdraws the exemptions of triangles to be removed. Returns one of them to represent all.
std::optional<Exemption> withdraw_exemptions(Workspace& work, const std::vector<int>& triangles);
/// Assigns that exemption to the new triangles with an angle below `bound` (radians).
void restore_exemptions(Workspace& work, const std::vector<int>& triangles, double bound,
                        std::optional<Exemption> reason);

/// Replaces the disc's triangles by the fan from a site. Triangles of the fan with an angle below `bound` (radians)
/// inherit the exemption.
/// @return the fan's triangles. Fewer triangles may leave unused indices: see close_gaps.
std::vector<int> replace_by_fan(Workspace& work, const Cavity& disc, int apex_site, double bound);

/// Moves the last triangles, with their exemptions, to the unused indices.
/// @return old and new index of each moved triangle, in order.
std::vector<std::pair<int, int>> close_gaps(Workspace& work);
/// Also removes from a list of triangles those that are gone, and adds all that moved.
void close_gaps(Workspace& work, std::vector<int>& touched);

}  // namespace mq::triangulate

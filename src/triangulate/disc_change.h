// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "triangulate/disc.h"
#include "triangulate/sizing.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Whether the spokes of a fan keep the bounds on lengths and turns. `apex_site` as for fan_angle.
bool within_bounds(const Workspace& work, const Sizing& sizing, const Disc& disc, const Corner& apex, int apex_site);

/// Takes the exemptions of triangles that are about to go. One of them stands for all.
std::optional<Exemption> take_exemptions(Workspace& work, const std::vector<int>& triangles);
/// Gives it to those of their successors that have an angle below `bound` (radians).
void exempt_bad(Workspace& work, const std::vector<int>& triangles, double bound, std::optional<Exemption> reason);

/// Puts the fan from a site in the place of the disc's triangles. What has an angle below `bound` (radians) among them
/// is exempt for the reason that was there.
/// @return the fan's triangles. Triangles may be gone: see close_gaps.
std::vector<int> put_fan(Workspace& work, const Disc& disc, int apex_site, double bound);

/// Moves the last triangles, with their exemptions, to the places of those that are gone.
/// @return from where and to where, in the order in which it happened.
std::vector<std::pair<int, int>> close_gaps(Workspace& work);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/vec.h"

/// Proofs by planes: the algorithm of Gilbert, Johnson and Keerthi 1988 looks for the point of a convex set nearest to
/// the origin, and ends as soon as the plane across the direction to it separates the two.
namespace mq::curve {

/// Whether a plane was found from which both hulls are away: together by more than `margin`, mm. False says nothing
/// where they are nearer than that, or nearly so.
bool hulls_apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double margin);

/// Whether a direction was found along which each of the vectors has more than `margin` (mm): their cone is then
/// pointed, and no sum of them with positive weights is zero.
bool in_open_half_space(const std::vector<Vec3>& vectors, double margin);

}  // namespace mq::curve

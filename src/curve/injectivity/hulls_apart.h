// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/vec.h"

/// Proofs by planes: the algorithm of Gilbert, Johnson and Keerthi 1988 looks for the point of a convex set nearest to
/// the origin, and ends as soon as the plane across the direction to it separates the two.
namespace mq::curve {

/// Whether a plane between two convex hulls was found whose distances from both add up to more than `margin`, mm. False
/// decides nothing if the hulls are nearer than that, or nearly so.
bool hulls_apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double margin);

/// Whether a direction was found along which the component of each of the vectors is more than `margin` (mm). Their
/// cone is pointed then, and no sum of them with positive weights is zero.
bool in_open_half_space(const std::vector<Vec3>& vectors, double margin);

}  // namespace mq::curve

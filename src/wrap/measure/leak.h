// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// A path from outside to a place that is to stay dry.
struct Leak {
    Vec3 dry = Vec3::Zero();
    std::vector<Vec3> path;  ///< from the dry place to beside the box of the input
    Vec3 narrowest = Vec3::Zero();
    double width = 0.0;  ///< diameter of the largest ball that passes there, mm, up to a spacing; wrapping with a
                         ///< larger gap closes the leak
};

/// The path on which the ball reaches a place: among those whose narrowest place is widest, the shortest. Nothing if
/// the ball does not reach the place.
/// @throws Cancelled
std::optional<Leak> find_leak(const NodeStates& states, const Vec3& dry, const Progress& progress);

}  // namespace mq::wrap

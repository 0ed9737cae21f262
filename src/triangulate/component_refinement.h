// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/stopwatch.h"
#include "triangulate/refinement.h"

namespace mq::triangulate {

/// Refines the connected components of the mesh of `whole` at a time, each on one thread. Leaves it as it is where one
/// of them has most of the triangles, and where they would have more together than the budget allows. The result does
/// not depend on the number of threads.
/// @param stages  receives the seconds of the stages, summed over the components
/// @return whether the mesh was refined, so that only Refinement::finish is left to do
/// @throws Cancelled
bool refine_components(Refinement& whole, StageTimes& stages);

}  // namespace mq::triangulate

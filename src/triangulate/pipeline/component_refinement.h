// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/stopwatch.h"
#include "triangulate/pipeline/refinement.h"

namespace mq::triangulate {

/// Refines the connected components of the mesh of `whole` at a time, each on one thread. Leaves it as it is where one
/// of them is most of the work, and where they would have more together than the budget allows. The result does
/// not depend on the number of threads.
/// @param measured  measurements of the mesh, before and after
/// @param stages  receives the seconds of the stages, component by component
/// @return whether the mesh was refined
/// @throws Cancelled
bool refine_components(Refinement& whole, ChordErrorCache& measured, StageTimes& stages);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "inspection/clearance.h"
#include "triangulate/work_mesh/result.h"

namespace mq::workflows {

/// The distances of all pairs of bodies; points are in the model's frame, triangles those of the given surfaces.
/// Surfaces that are not closed are no bodies, but have distances, too: none of them has anything inside.
/// @param slack  mm, by body: see inspection::clearances
/// @throws InvalidInput for a surface without triangles, naming the body by its number; Cancelled
std::vector<inspection::Clearance> measure_clearances(const std::vector<const triangulate::Result*>& bodies,
                                                      const std::vector<double>& slack,
                                                      const inspection::ClearanceOptions& options, Progress& progress);

}  // namespace mq::workflows

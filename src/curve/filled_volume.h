// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/stage_clock.h"
#include "curve/volume.h"
#include "curve/volume_repair.h"

namespace mq::curve {

/// The inside of a part, curved and repaired.
struct FilledVolume {
    Volume volume;
    VolumeRepairs repairs;           ///< of the filling that was kept
    int fillings = 1;                ///< that were tried
    std::vector<std::string> notes;  ///< that the solids were filled again, and what came of it
};

/// Fills the solids and repairs their tetrahedra. Where some stay invalid, mostly since they reach from one side of the
/// surface to the other, the solids are filled again with more vertices inside, unless all of them lie on invalid
/// triangles of the surface. What is kept is the filling with fewest invalid tetrahedra, of equal ones the first; the
/// last is the one that fails or is no better than that before it.
/// @param surface gets the vertices and shapes of what is kept.
/// @throws CannotFill, GeometryError where the first filling fails; Cancelled.
FilledVolume fill_and_repair(Surface& surface, const geometry::Topology& topology, Progress& progress,
                             StageClock& clock);

/// The surface without a vertex inside, and the part of the usual grading (see fill()) -> the volume in it.
using Filler = std::function<FilledVolume(Surface&, double)>;

/// As fill_and_repair, by any filler.
FilledVolume best_filling(Surface& surface, const Filler& filler);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::boolean {

/// The constants that tune the repair of operands. docs/measurements/tuning.md says what each does at half and at
/// double its value.
struct InputTuning {
    /// An open component is closed only if the area to be added is at most this fraction of its own: a box without
    /// its lid (0.2) and most of a sphere are, half a sphere (0.5) and a sheet (1) are not.
    MESHQUALITY_TUNED(double, kLargestFilledShare, 1.0 / 3.0);
    /// Open components that cannot be closed are left out if together they have at most this fraction of the
    /// operand's area; those that are attached to the rest along edges of three or more triangles (inner walls,
    /// fins) up to half of it.
    MESHQUALITY_TUNED(double, kLargestScrapShare, 0.05);
    /// Corners up to which every possible triangle of a loop is tested against the surface; the test is cubic in
    /// them.
    MESHQUALITY_TUNED(std::size_t, kTestedLoop, 80);
    /// Rounds of filling holes anew at most.
    MESHQUALITY_TUNED(int, kFillingRounds, 4);
    /// Vertices of a component tried as starts of a ray.
    MESHQUALITY_TUNED(std::size_t, kRayStarts, 8);
};

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/chord_measure.h"
#include "triangulate/crossing_finder.h"

namespace mq::triangulate {

/// What was found out about the mesh and still holds, from stage to stage.
struct Findings {
    explicit Findings(Workspace& work) : chords(work), crossings(work) {}

    ChordMeasure chords;
    CrossingFinder crossings;
};

}  // namespace mq::triangulate

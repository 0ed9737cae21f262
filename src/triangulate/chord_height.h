// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/chord_measure.h"

namespace mq::triangulate {

/// A distance of the mesh from the part, and where that is.
struct ChordHeight {
    double distance = 0.0;      ///< mm
    int triangle = -1;          ///< of the working mesh; -1: nothing was measured
    Vec3 point = Vec3::Zero();  ///< of the mesh, in the part's frame
    bool of_the_part = false;   ///< a CAD edge there lies off its face as far
};

/// The largest distance between the mesh and the part. `asked` in mm: the tolerance; 0: none.
ChordHeight measure_chord_height(Workspace& work, ChordMeasure& measure, double asked);

}  // namespace mq::triangulate

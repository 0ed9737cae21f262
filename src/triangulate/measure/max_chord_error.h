// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/measure/chord_error.h"

namespace mq::triangulate {

/// A distance of the mesh from the CAD model, and its place.
struct MaxChordError {
    double distance = 0.0;      ///< mm
    int triangle = -1;          ///< index in the working mesh; -1: nothing was measured
    Vec3 point = Vec3::Zero();  ///< point of the mesh, in the shape's frame
    bool of_the_shape = false;  ///< whether a CAD edge deviates from its face by this distance there
};

/// Returns the largest distance between the mesh and the CAD model. `asked`: the chord tolerance in mm; 0: none.
MaxChordError measure_chord_height(Workspace& work, ChordErrorCache& measure, double asked);

}  // namespace mq::triangulate

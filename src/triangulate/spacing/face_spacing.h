// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "triangulate/initial/initial_triangulation.h"
#include "triangulate/spacing/spacing_field.h"

namespace mq::triangulate {

/// Adds to the field the spacings that the inside of the faces requires, so that samples become smaller before a
/// place of high curvature is reached. Measured at the corners of cells about as small as the spacing in them.
/// Planes, cylinders, spheres, cones and tori are skipped: their borders have the smallest spacing.
void add_face_spacings(geometry::Session& session, const InitialTriangulation& coarse, const SinglePrecisionGrid& grid,
                       const SpacingBounds& bounds, SpacingField& field, const Progress& progress);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "geometry/initial_triangulation.h"
#include "triangulate/curvature_radius.h"

namespace mq::triangulate {

/// Adds to the field what spacings the inside of the faces asks for, so that samples grow smaller before a place of
/// high curvature is reached. Measured at the corners of cells about as small as the spacing in them. Planes,
/// cylinders, spheres, cones and tori need none: their borders show the smallest spacing.
void add_face_spacings(geometry::Session& session, const geometry::InitialTriangulation& coarse, const SingleGrid& grid,
                       const SpacingBounds& bounds, SpacingField& field, const Progress& progress);

}  // namespace mq::triangulate

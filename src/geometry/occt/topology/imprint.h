// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/occt/topology/ordered_shape.h"

namespace mq::geometry {

/// The shape with one face wherever faces of two solids lie on each other within `within` (mm) and their tolerances, so
/// that both solids have the same triangles there (OrderedShape::behind). Faces that touch in a region are divided
/// along the border of the region. The shape itself does not change.
///
/// OpenCASCADE's general fuse (BOPAlgo_Builder) does it for coinciding faces only (BOPAlgo_GlueShift): solids that
/// overlap are not divided where they cross. A solid stays as it is, and is named in `faults`, if the fuse loses area
/// of it or makes an invalid face, or if it lies on the same side of a face as another solid.
/// @throws Cancelled
OrderedShape imprint_contacts(OrderedShape whole, double within, std::vector<std::string>& faults,
                              const Progress* progress);

}  // namespace mq::geometry

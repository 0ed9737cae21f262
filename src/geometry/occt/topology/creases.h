// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/occt/topology/ordered_shape.h"

namespace mq::geometry {

/// The shape with its surfaces cut along their creases: parameter lines across which the normal jumps, as those of
/// splines through corners, and lines that are a point in space. The shape itself does not change. Pieces have surfaces
/// of their own, so that each has its own normal on the crease. Where OpenCASCADE's division (ShapeUpgrade) loses area
/// the shape stays as it is, and `faults` says so.
/// @throws Cancelled
OrderedShape cut_at_creases(OrderedShape whole, std::vector<std::string>& faults, const Progress* progress);

}  // namespace mq::geometry

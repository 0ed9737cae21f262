// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "base/vec.h"

class TopoDS_Shape;

namespace mq::geometry {

/// The distance of each point from the shape's trimmed faces, mm. A point inside a solid has its distance from the
/// boundary, not 0. Independent of the model and its queries, so that it can check their results. The shape is only
/// read.
/// @throws GeometryError when the distance from a face cannot be computed; Cancelled.
std::vector<double> distances_to_faces(const TopoDS_Shape& shape, const std::vector<Vec3>& points,
                                       Progress* progress = nullptr);

}  // namespace mq::geometry

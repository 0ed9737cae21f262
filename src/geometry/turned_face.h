// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/face_triangulation.h"

namespace mq::geometry {

/// Turns every triangle over, and keeps the links between them: for a face whose outward normal is -(Su x Sv).
void turn_over(FaceTriangulation& face);

}  // namespace mq::geometry

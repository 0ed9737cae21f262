// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

#include "base/progress.h"

namespace mq::geometry {

/// The shape with a curve in (u, v) for every edge on a plane. Files leave these curves out, and OpenCASCADE projects
/// an edge anew whenever its curve is asked for. Edges that get curves, and what consists of them, are copies, which
/// share all geometry with the shape; the shape itself does not change. Sub-shapes keep their order, and a shape at
/// several places stays one.
/// @throws Cancelled
TopoDS_Shape with_plane_curves(const TopoDS_Shape& shape, const Progress* progress);

}  // namespace mq::geometry

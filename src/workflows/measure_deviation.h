// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "geometry/engine.h"
#include "inspection/deviation.h"
#include "triangulate/work_mesh/result.h"

class TopoDS_Shape;

namespace mq::workflows {

/// Signed distances of points from a surface, or from the shape of which it is the mesh.
/// @param shape  null: distances are from the mesh
/// @throws as inspection::measure_deviation
inspection::Deviation measure_deviation(geometry::Engine& engine, const std::vector<Vec3>& points,
                                        const triangulate::Result& reference, const TopoDS_Shape* shape,
                                        const inspection::DeviationOptions& options, Progress& progress);

}  // namespace mq::workflows

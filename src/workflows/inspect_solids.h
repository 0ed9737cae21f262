// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "inspection/thickness.h"
#include "triangulate/work_mesh/result.h"

namespace mq::workflows {

/// A closed, oriented surface of one or more bodies, fit for inspection.
struct SolidSurface {
    triangulate::Result surface;
    /// The body of each triangle, numbered from 0 on; empty: all of them are one.
    std::vector<std::int32_t> body;
};

/// The surface of a shape with meshed solids, each of which is a body; any other surface is repaired like an operand of
/// a Boolean and is one body, as a note of its report says.
/// @throws InvalidInput for what bounds no volume, naming the defect and the remedy; Cancelled.
SolidSurface solid_surface(const triangulate::Result& given, Progress& progress);

/// A surface, and how thick the solids are that it bounds.
struct ThicknessSurface {
    SolidSurface solids;
    inspection::Thickness thickness;
    StageTimes seconds;
    double cpu_seconds = 0.0;
};

/// @throws as solid_surface and inspection::thickness
ThicknessSurface measure_thickness(const triangulate::Result& given, const inspection::ThicknessOptions& options,
                                   Progress& progress);

}  // namespace mq::workflows

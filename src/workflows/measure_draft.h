// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/progress.h"
#include "geometry/engine.h"
#include "inspection/draft.h"
#include "triangulate/work_mesh/result.h"
#include "workflows/inspect_solids.h"

class TopoDS_Shape;

namespace mq::workflows {

/// A surface, and its draft.
struct DraftSurface {
    SolidSurface solids;
    inspection::MouldDraft draft;
    std::size_t exact_normals = 0;  ///< triangles whose normal is that of their CAD face
};

/// @param shape  null: there is no CAD
/// @throws as solid_surface and inspection::draft
DraftSurface measure_draft(geometry::Engine& engine, const triangulate::Result& given, const TopoDS_Shape* shape,
                           const inspection::DraftOptions& options, Progress& progress);

}  // namespace mq::workflows

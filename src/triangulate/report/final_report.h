// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/quality/mesh_report.h"
#include "triangulate/measure/chord_error.h"
#include "triangulate/measure/self_intersections.h"
#include "triangulate/report/manifold_output.h"
#include "triangulate/work_mesh/options.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Measurements of the mesh that remain valid from stage to stage.
struct MeasurementCache {
    explicit MeasurementCache(Workspace& work) : chords(work), crossings(work) {}

    ChordErrorCache chords;
    SelfIntersections crossings;
};

/// Measures the final mesh: angles, distances from the CAD model, self-intersections; names bounds that are not met,
/// and why. `chord`: chord tolerance in mm; 0: none. Measurements in `findings` are reused.
/// @throws Cancelled
mesh::MeshReport final_report(Workspace& work, MeasurementCache& findings, const Output& out,
                              const TriangulateOptions& options, double chord);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/quality/mesh_report.h"
#include "triangulate/measure/body_contacts.h"
#include "triangulate/measure/chord_error.h"
#include "triangulate/measure/max_chord_error.h"
#include "triangulate/measure/self_intersections.h"
#include "triangulate/report/joined_corners.h"
#include "triangulate/report/manifold_output.h"
#include "triangulate/work_mesh/options.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Measurements of the mesh that remain valid from stage to stage.
struct MeasurementCache {
    explicit MeasurementCache(Workspace& work) : chords(work), crossings(work), bodies(work, crossings) {}

    ChordErrorCache chords;
    SelfIntersections crossings;
    BodyContacts bodies;
};

/// Measures what takes memory: distances from the CAD model and self-intersections, which stay in `findings`. `chord`:
/// chord tolerance in mm; 0: none.
/// @throws Cancelled
MaxChordError measure_against_part(Workspace& work, MeasurementCache& findings, double chord);

/// Measures the final mesh: angles and topology; names bounds that are not met, and why. `farthest` is of
/// measure_against_part, which must have been called.
/// @throws Cancelled
mesh::MeshReport final_report(const Workspace& work, MeasurementCache& findings, const MaxChordError& farthest,
                              const Output& out, JoinedCorners& joined, const TriangulateOptions& options,
                              double chord);

}  // namespace mq::triangulate

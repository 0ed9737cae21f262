// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "curve/surface_editor.h"

namespace mq::curve {

/// How often each operation was carried out.
struct SurfaceRepairs {
    int invalid_before = 0;
    int invalid_after = 0;
    int bulge_splits = 0;  ///< edges split because they turn too far
    int reached = 0;       ///< vertices that lie off the CAD, towards which nodes leave it
    int swaps = 0;
    int collapses = 0;
    int curved_edges = 0;
    int cusps = 0;          ///< opened
    int cusp_splits = 0;    ///< cusps whose edges were halved, so that opening them costs little
    int snapped = 0;        ///< vertices of faces that became vertices of CAD edges
    int regrown = 0;        ///< cavities filled anew
    int refined_faces = 0;  ///< made finer around invalid triangles until more of them were valid
    int splits = 0;
};

/// Splits edges that deviate from their chord by more than the allowable part of their length (section 5.5), then
/// repairs invalid and poor triangles in the paper's order: swap, collapse, curve an edge on the face, refine.
SurfaceRepairs repair_surface(SurfaceEditor& editor, const Progress& progress);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "curve/surface/editor.h"

namespace mq::curve {

/// The number of times that each operation was carried out.
struct SurfaceRepairs {
    int invalid_before = 0;
    int invalid_after = 0;
    int bulge_splits = 0;  ///< edges split because their deviation is too large
    int reached = 0;       ///< vertices that deviate from the CAD, towards which nodes leave it
    int followed = 0;      ///< triangles whose inner edges follow the parameters of their face
    int swaps = 0;
    int collapses = 0;
    int curved_edges = 0;
    int cusps = 0;          ///< cusps opened
    int cusp_splits = 0;    ///< cusps whose edges were halved, so that opening them adds little deviation
    int snapped = 0;        ///< vertices of faces that became vertices of CAD edges
    int regrown = 0;        ///< cavities filled anew
    int refined_faces = 0;  ///< faces refined around invalid triangles until more of them were valid
    int splits = 0;
};

/// The elements to be repaired: poor ones as well, as in meshes of our own, or invalid ones only, as in given meshes,
/// which stay unchanged unless they must change.
enum class RepairScope { Poor, Invalid };

/// Splits edges whose deviation from the chord exceeds the allowable fraction of their length (section 5.5), then
/// repairs invalid and poor triangles in the paper's order: swap, collapse, curve an edge on the face, refine.
/// Valid triangles and edges stay where the scope says so.
SurfaceRepairs repair_surface(SurfaceEditor& editor, const Progress& progress, RepairScope scope = RepairScope::Poor);

}  // namespace mq::curve

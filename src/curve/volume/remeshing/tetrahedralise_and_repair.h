// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "base/stopwatch.h"
#include "curve/volume/repair.h"
#include "curve/volume/tetrahedral_mesh.h"

namespace mq::curve {

/// The inside of a model, curved and repaired.
struct RepairedTetrahedralMesh {
    TetrahedralMesh volume;
    VolumeRepairs repairs;
};

/// Fills the solids and repairs their tetrahedra. Where some stay invalid, mostly since they reach from one side of the
/// surface to the other, the cavities around them are filled again with more vertices inside (remesh_and_repair).
/// Every order is filled as for order 2: straight tetrahedra can be curved later, and orders compared on one mesh.
/// @param surface gets the vertices and shapes inside.
/// @param field bounds the lengths of edges inside; null: none
/// @throws tetrahedralise::MeshingFailed where the filling fails; Cancelled.
RepairedTetrahedralMesh tetrahedralise_and_repair(geometry::Session& session, CurvedSurface& surface,
                                                  Progress& progress, StageTimer& clock,
                                                  const SizeField* field = nullptr);

}  // namespace mq::curve

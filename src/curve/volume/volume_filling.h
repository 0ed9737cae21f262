// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "curve/volume/repair.h"
#include "curve/volume/tetrahedral_mesh.h"

namespace mq::curve {

/// The inside of a model, curved and repaired.
struct FilledTetrahedralMesh {
    TetrahedralMesh volume;
    VolumeRepairs repairs;           ///< repairs of the filling that was kept
    int fillings = 1;                ///< fillings that were tried
    std::vector<std::string> notes;  ///< that the solids were filled again, and with which result
};

/// Fills the solids and repairs their tetrahedra. Where some stay invalid, mostly since they reach from one side of the
/// surface to the other, the solids are filled again with more vertices inside, unless all of them lie on invalid
/// triangles of the surface. The filling with fewest invalid tetrahedra is kept, among equal ones the first; the search
/// ends with a filling that fails or is no better than the one before.
/// @param surface gets the vertices and shapes of the filling that is kept.
/// @throws MeshingFailed, GeometryError where the first filling fails; Cancelled.
FilledTetrahedralMesh fill_and_repair(CurvedSurface& surface, const geometry::Topology& topology, Progress& progress,
                                      StageClock& clock);

/// Maps the surface without a vertex inside, and the factor of the usual grading (see fill()), to the volume in it.
using Filler = std::function<FilledTetrahedralMesh(CurvedSurface&, double)>;

/// The same as fill_and_repair with any filler.
FilledTetrahedralMesh best_filling(CurvedSurface& surface, const Filler& filler);

}  // namespace mq::curve

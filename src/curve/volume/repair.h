// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "curve/surface/repair.h"
#include "curve/volume/tetrahedral_mesh.h"

namespace mq::curve {

struct VolumeRepairs {
    int invalid_before = 0;
    int invalid_after = 0;
    int edge_swaps = 0;
    int face_swaps = 0;
    int collapses = 0;
    int curved_edges = 0;
    int relocated_faces = 0;      ///< faces whose inner nodes moved
    int relocations = 0;          ///< inner vertices moved
    int splits = 0;               ///< vertices put on inner edges, faces and into tetrahedra
    int patches = 0;              ///< patches whose inner edges and faces were curved
    int cavities = 0;             ///< cavities around invalid elements that were filled anew
    std::size_t evaluations = 0;  ///< Jacobians evaluated to curve patches
};

/// Repairs invalid and poor tetrahedra; the surface stays as it is.
///
/// First the elements that no curving can help, because three edges on the surface meet in one of their corners nearly
/// in a plane: swaps, then splits. Then the bad ones with the layers around them form patches, whose inner edges and
/// faces are curved. Elements that are bad after that are swapped, collapsed or split, and curved again. A failed
/// repair is not tried again while the neighbours are the same, so that the work is proportional to the number of bad
/// elements. Tetrahedra on folded triangles of the surface are left alone, as nothing inside can make them valid. Valid
/// ones keep their corners where the scope says so.
VolumeRepairs repair_volume(TetrahedralMesh& volume, const Progress& progress, RepairScope scope = RepairScope::Poor);

}  // namespace mq::curve

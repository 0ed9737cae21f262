// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "tetrahedralise/cells/tetrahedralisation.h"
#include "tetrahedralise/surface_constraints.h"

namespace mq::tetrahedralise {

/// Removes the cells that do not lie inside the surface, all of whose triangles are faces.
/// @param outer the first of four vertices that lie outside
/// @throws MeshingFailed where the surface does not separate inside from outside.
void remove_outside(Tetrahedralisation& mesh, const SurfaceConstraints& surface, int outer);

/// Moves the points that recovery has put on the surface inwards, the last one first, and fills the gaps, so that the
/// surface has its own triangles again (George, Borouchaki and Saltel 2003). Cells outside were removed before.
/// @throws MeshingFailed if rounding leaves no place for one of the points.
void move_divisions_inwards(Tetrahedralisation& mesh, const SurfaceConstraints& surface);

}  // namespace mq::tetrahedralise

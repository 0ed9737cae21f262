// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "curve/surface/editor.h"
#include "curve/volume/tetrahedral_mesh.h"

namespace mq::curve {

/// A surface whose shapes are the same polynomials, written with one degree more.
/// @param tetrahedra  inside
CurvedSurface with_degree_raised(const CurvedSurface& surface, const std::vector<Tetrahedron>& tetrahedra);

/// Places the edges and triangles of a surface on the CAD anew, after their degree was raised. Where an element becomes
/// invalid by that, its edges and faces on the surface get back the shapes of lower degree, so that in the end no
/// element is invalid that was valid.
/// @param volume  of the editor's surface; nullptr: there are triangles only
/// @return how many triangles keep shapes of lower degree.
std::size_t place_where_valid(SurfaceEditor& editor, TetrahedralMesh* volume, const Progress& progress);

}  // namespace mq::curve

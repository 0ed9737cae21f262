// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "curve/surface/editor.h"
#include "curve/volume/tetrahedral_mesh.h"

namespace mq::given {

/// The same surface with its polynomials written with one degree more.
/// @param tetrahedra  those inside of the surface
curve::CurvedSurface with_degree_raised(const curve::CurvedSurface& surface,
                                        const std::vector<curve::Tetrahedron>& tetrahedra);

/// Places the edges and triangles of a surface on the CAD again, after their degree was raised. If an element becomes
/// invalid by that, its edges and faces on the surface get back their shapes of lower degree: no element that was valid
/// becomes invalid.
/// @param volume  the tetrahedra inside of the editor's surface; nullptr: there are triangles only
/// @return how many triangles keep shapes of lower degree.
std::size_t place_where_valid(curve::SurfaceEditor& editor, curve::TetrahedralMesh* volume, const Progress& progress);

}  // namespace mq::given

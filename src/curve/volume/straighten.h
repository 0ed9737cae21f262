// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <set>

#include "curve/surface/editor.h"
#include "curve/volume/tetrahedral_mesh.h"

namespace mq::curve {

/// The last resort where repairs fail: invalid elements lose the shapes of their edges and faces, also those on the
/// CAD, and so do neighbours that become invalid by it, until none is left or straight elements are invalid themselves.
/// @return the elements that were made straight, by their index.
std::set<int> straighten_triangles(SurfaceEditor& editor);
/// @param editor edits the same surface; its triangles are measured again.
std::set<int> straighten_tetrahedra(TetrahedralMesh& volume, SurfaceEditor& editor);

}  // namespace mq::curve

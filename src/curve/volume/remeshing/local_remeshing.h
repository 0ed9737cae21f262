// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "curve/volume/repair.h"
#include "curve/volume/tetrahedral_mesh.h"

namespace mq::curve {

/// Tetrahedra of a surface before it was repaired, by the surface's vertices.
struct TetrahedraInside {
    std::vector<std::array<int, 4>> corners;  ///< flat or inverted only where they were given so
    std::vector<int> volume;                  ///< by tetrahedron: the volume of the model
};

/// Counts of local remeshing.
struct LocalRemeshing {
    std::size_t removed = 0;  ///< tetrahedra that no longer fitted the surface, or had no volume
    std::size_t added = 0;
    std::size_t cavities = 0;  ///< filled anew
};

/// Takes over tetrahedra after the surface around them was repaired (Dey, O'Bara, Shephard 1999, section 5.5, in three
/// dimensions): those with triangles, edges or vertices that the surface no longer has are removed, with those that
/// have no positive volume and all others at the inner vertices of these, and the cavities between the surface and the
/// other tetrahedra are filled anew. A cavity that cannot be filled grows by a layer of tetrahedra, up to the whole
/// volume.
/// @param triangles_before  how many triangles of the surface, dead or alive, are older than its repair
/// @throws tetrahedralise::MeshingFailed naming the solid that cannot be filled.
TetrahedralMesh remesh_locally(CurvedSurface& surface, std::size_t triangles_before, const TetrahedraInside& inside,
                               LocalRemeshing& done, const Progress& progress);

/// Where tetrahedra stay invalid after repair, removes them with ever more layers of others around them, fills the
/// cavities anew with ever more vertices inside, and repairs again. A result is kept if fewer of them stay invalid, not
/// counting those on folded triangles of the surface, which nothing inside can help.
void remesh_and_repair(std::optional<TetrahedralMesh>& volume, CurvedSurface& surface, RepairScope scope,
                       LocalRemeshing& done, const Progress& progress);

}  // namespace mq::curve

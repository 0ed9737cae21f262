// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/vec.h"

/// Meshes of other programs: found on the CAD, curved, and repaired without a change of sound elements.
namespace mq::given {

/// The corners of a mesh of triangles and tetrahedra that another program made.
struct GivenMesh {
    std::vector<Vec3> nodes;  ///< mm; nodes that are no corners are ignored
    /// The triangles on the surface. If there are tetrahedra, only triangles between two of them need to be listed: the
    /// others are found.
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 4>> tetrahedra;
    std::vector<int> regions;  ///< by tetrahedron: a number that differs between bodies; empty: there is one body
};

/// @throws InvalidInput naming the first element with a node that does not exist, is not finite or is named twice; also
/// for an empty mesh.
void require_sound(const GivenMesh& mesh);

/// Orders the corners of the tetrahedra of each connected region so that neighbours see their common face from its two
/// sides, and that the whole region has a positive volume. Tetrahedra with a negative volume are inverted then.
/// @return how many tetrahedra were reversed.
std::size_t orient_tetrahedra(GivenMesh& mesh);

/// Whether two triangles with the same corners have the same orientation.
bool same_turn(const std::array<int, 3>& a, const std::array<int, 3>& b);

/// The triangles on the surface: the faces of exactly one tetrahedron, the faces between two bodies, and given
/// triangles that are faces of tetrahedra; all given triangles if there are no tetrahedra. Each triangle comes once,
/// seen from outside of the tetrahedron with the lower index.
std::vector<std::array<int, 3>> surface_of(const GivenMesh& mesh);

}  // namespace mq::given

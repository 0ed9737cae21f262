// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/vec.h"

/// Meshes that come from elsewhere: found on the CAD, curved, and repaired without changing what is sound.
namespace mq::curve {

/// The corners of a mesh of triangles and tetrahedra that another program made.
struct GivenMesh {
    std::vector<Vec3> nodes;  ///< mm; those that are no corners are left alone
    /// On the surface. Where there are tetrahedra, only those between two of them matter: the others are found.
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 4>> tetrahedra;
    std::vector<int> regions;  ///< by tetrahedron: a number that differs between bodies; empty: there is one body
};

/// @throws InvalidInput naming the first element with a node that is not there, not finite or named twice, and an empty
/// mesh.
void require_sound(const GivenMesh& mesh);

/// Numbers the tetrahedra of each connected part so that neighbours see their common face from its two sides, and that
/// the whole part has a positive volume: those that have a negative one then are inverted.
/// @return how many were turned.
std::size_t orient_tetrahedra(GivenMesh& mesh);

/// Whether two triangles of the same corners go round them in the same way.
bool same_turn(const std::array<int, 3>& a, const std::array<int, 3>& b);

/// The triangles on the surface: the faces of one tetrahedron only, those between two bodies, and given triangles that
/// are faces of tetrahedra; all given triangles where there are no tetrahedra. Each comes once, seen from outside of
/// the tetrahedron of lower index.
std::vector<std::array<int, 3>> surface_of(const GivenMesh& mesh);

}  // namespace mq::curve

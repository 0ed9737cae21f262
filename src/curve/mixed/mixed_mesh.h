// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "curve/elements/element_kind.h"
#include "curve/given/given_mesh.h"

/// Meshes of prisms, pyramids, hexahedra and quadrilaterals beside simplices: curved without a change of their
/// elements.
namespace mq::curve {

/// An element by its corners in Gmsh's order; those past the corners of its kind are -1.
struct MixedElement {
    ElementKind kind = ElementKind::Tetrahedron;
    std::array<std::int32_t, 8> corners{-1, -1, -1, -1, -1, -1, -1, -1};
    int region = 0;  ///< a number that differs between bodies

    std::size_t count() const { return static_cast<std::size_t>(full_node_count(kind, 1)); }
};

/// The corners of a mesh of elements of any kind that another program made.
struct MixedMesh {
    std::vector<Vec3> nodes;             ///< mm
    std::vector<MixedElement> elements;  ///< solids; without any, the surface
    std::vector<MixedElement> listed;    ///< triangles and quadrilaterals beside solids: interfaces are found by them

    bool has_volume() const { return !elements.empty() && dimension_of(elements.front().kind) == 3; }
};

/// @throws InvalidInput naming the first element with a node that is not there, not finite or named twice, and an empty
/// mesh.
void require_sound(const MixedMesh& mesh);

/// Corners of a face of an element, outward.
std::vector<std::int32_t> face_corners(const MixedElement& element, std::size_t face);

/// A mesh of simplices on the same nodes, which the given one is found on the CAD by.
///
/// Each element is the cone of its lowest corner over the faces that do not have it, and each quadrilateral is divided
/// from its lowest corner (Dompierre, Labbe, Vallet, Camarero 1999): so neighbours divide what they share alike.
struct Simplices {
    GivenMesh mesh;
    std::vector<std::size_t> element;  ///< by simplex
};
Simplices divided_into_simplices(const MixedMesh& mesh);

/// Turns solid elements round that see the faces to their neighbours from the wrong side, see orient_tetrahedra().
/// @return how many were turned.
std::size_t orient_elements(MixedMesh& mesh);

/// The two triangles of a quadrilateral, or the triangle itself.
std::vector<std::array<int, 3>> triangles_of(const std::vector<std::int32_t>& corners);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "elements/product/element_kind.h"
#include "given/matching/given_mesh.h"

/// Meshes of prisms, pyramids, hexahedra and quadrilaterals together with simplices. They are curved without a change
/// of their connectivity.
namespace mq::given {

/// An element by its corners in Gmsh's order; unused entries are -1.
struct MixedElement {
    elements::ElementKind kind = elements::ElementKind::Tetrahedron;
    std::array<std::int32_t, 8> corners{-1, -1, -1, -1, -1, -1, -1, -1};
    int region = 0;  ///< a number that differs between bodies

    std::size_t count() const { return static_cast<std::size_t>(elements::full_node_count(kind, 1)); }
};

/// The corners of a mesh of elements of any kind that another program made.
struct MixedMesh {
    std::vector<Vec3> nodes;             ///< mm
    std::vector<MixedElement> elements;  ///< the solids; if there are none, the surface
    std::vector<MixedElement> listed;    ///< triangles and quadrilaterals of a mesh with solids: they mark interfaces

    bool has_volume() const { return !elements.empty() && elements::dimension_of(elements.front().kind) == 3; }
};

/// @throws InvalidInput naming the first element with a node that does not exist, is not finite or is named twice; also
/// for an empty mesh.
void require_sound(const MixedMesh& mesh);

/// Corners of a face of an element, oriented outward.
std::vector<std::int32_t> face_corners(const MixedElement& element, std::size_t face);

/// A mesh of simplices on the same nodes, by which the given mesh is found on the CAD.
///
/// Each element is divided into the cones from its lowest corner over the faces without it, and each quadrilateral from
/// its lowest corner (Dompierre, Labbe, Vallet, Camarero 1999): so neighbours divide a common face alike.
struct Simplices {
    GivenMesh mesh;
    std::vector<std::size_t> element;  ///< by simplex: the element that it belongs to
};
Simplices divided_into_simplices(const MixedMesh& mesh);

/// Reverses solid elements that see the faces to their neighbours from the wrong side, see orient_tetrahedra().
/// @return how many were reversed.
std::size_t orient_elements(MixedMesh& mesh);

/// The two triangles of a quadrilateral, or the triangle itself.
std::vector<std::array<int, 3>> triangles_of(const std::vector<std::int32_t>& corners);

}  // namespace mq::given

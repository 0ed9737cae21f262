// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Elements that share a name in a file: a patch of triangles, the tetrahedra of a solid, the lines of an edge.
struct Group {
    std::string name;
    std::array<std::uint8_t, 3> colour{};  ///< red, green, blue; for formats of printing
};

/// The patches of a mesh, and to which of them each triangle belongs.
struct Patches {
    std::vector<Group> groups;
    std::vector<std::int32_t> of_triangle;
    /// Whether they were asked for. Where not, formats that can do without names are written without.
    bool given = false;
};

/// Elements of one dimension and order in Gmsh's node order.
struct Elements {
    std::size_t width = 0;             ///< nodes of one element
    std::vector<std::int32_t> nodes;   ///< flat, `width` numbers an element
    std::vector<std::int32_t> entity;  ///< the CAD entity of each; empty when the mesh has no CAD
    std::vector<std::int32_t> group;   ///< index into the groups of the dimension

    std::size_t size() const { return group.size(); }
    const std::int32_t* of(std::size_t k) const { return nodes.data() + k * width; }
    /// The elements of each group, in ascending order.
    std::vector<std::vector<std::int32_t>> by_group(std::size_t groups) const;
};

/// What the writers of all formats see of a mesh, flat or curved, surface or volume.
struct ExportMesh {
    Vec3 origin = Vec3::Zero();
    double scale = 1.0;       ///< factor of the file's coordinates: 0.001 makes metres of mm
    std::vector<Vec3> nodes;  ///< mm, relative to origin
    std::vector<VertexEntity> node_entity;
    std::size_t corners = 0;  ///< the first nodes, which are corners of elements; the others lie inside of curved ones
    int order = 1;
    std::array<Elements, 4> elements;          ///< by dimension; those of dimension 0 are not used
    std::array<std::vector<Group>, 4> groups;  ///< likewise
    bool patches_given = false;                ///< Patches::given
    std::vector<std::int32_t> behind;          ///< by triangle: a tetrahedron that it is a face of, -1: none

    /// The node as it stands in the file.
    Vec3 point(std::size_t i) const { return (nodes[i] + origin) * scale; }
    const Elements& triangles() const { return elements[2]; }
    const Elements& tetrahedra() const { return elements[3]; }
    const std::vector<Group>& patches() const { return groups[2]; }
    const std::string& patch_of(std::size_t triangle) const {
        return groups[2][static_cast<std::size_t>(elements[2].group[triangle])].name;
    }
    /// The nodes of each patch, ascending.
    std::vector<std::vector<std::int32_t>> nodes_by_patch() const;
};

/// The mesh with its patches; without any all triangles are one patch, "Surface".
/// @throws InvalidInput for a mesh that require_valid refuses, and for patches that do not fit it
ExportMesh exported(const TriangleMesh& mesh, const Patches& patches = {}, double scale = 1.0);

/// Puts the patches into a mesh whose triangles are all but named. @throws InvalidInput where they do not fit
void set_patches(ExportMesh& mesh, const Patches& patches);

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "mesh/io/element_type.h"
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
    /// Whether patches were requested. If not, formats that can be written without names get none.
    bool given = false;
};

/// Elements of one type in Gmsh's node order.
struct Elements {
    const ElementType* type = nullptr;
    std::vector<std::int32_t> nodes;    ///< flat, `type->nodes` numbers an element
    std::vector<std::int32_t> entity;   ///< the CAD entity of each, -1: none; empty when the mesh has no CAD
    std::vector<std::int32_t> group;    ///< index into the groups of the dimension, or into ExportMesh::sets
    std::vector<std::size_t> lagrange;  ///< node order of VTK's Lagrange cells, as in ElementType::orders

    std::size_t size() const { return nodes.size() / type->nodes; }
    const std::int32_t* of(std::size_t k) const { return nodes.data() + k * type->nodes; }
};

/// Elements, and the number in a file of their first one, from 1.
struct NumberedElements {
    const Elements* elements;
    std::size_t first;
};

/// The number of elements in all blocks.
inline std::size_t count_of(const std::vector<NumberedElements>& blocks) {
    return blocks.empty() ? 0 : blocks.back().first - 1 + blocks.back().elements->size();
}

/// A piece of a list of indices.
struct Indices {
    const std::int32_t* first;
    const std::int32_t* last;

    const std::int32_t* begin() const { return first; }
    const std::int32_t* end() const { return last; }
};

/// What the writers of all formats see of a mesh, flat or curved, surface or volume, of one kind of elements or of
/// many.
struct ExportMesh {
    Vec3 origin = Vec3::Zero();
    double scale = 1.0;       ///< factor of the file's coordinates: 0.001 makes metres of mm
    std::vector<Vec3> nodes;  ///< mm, relative to origin
    std::vector<VertexEntity> node_entity;
    bool nodes_by_entity = false;  ///< whether formats with CAD entities list a node with the entity on which it lies
    std::vector<Elements> blocks;
    std::array<std::vector<Group>, 4> groups;  ///< by dimension; those of dimension 0 are not used
    bool patches_given = false;                ///< Patches::given
    /// Sets of groups, to which Elements::group are indices, for the mesh of another program: there an element may be
    /// in several groups or in none, groups have elements of any dimension, and `groups` is the same for all
    /// dimensions. Empty: each element is in one group of its dimension.
    std::vector<std::vector<std::int32_t>> sets;

    /// The node as it stands in the file.
    Vec3 point(std::size_t i) const { return (nodes[i] + origin) * scale; }
    bool is_given() const { return !sets.empty(); }
    int dimension() const;  ///< the highest one of the elements; 2 without any
    int order() const;      ///< likewise
    /// The triangles of a mesh of triangles.
    const Elements& triangles() const { return blocks.front(); }
    const std::vector<Group>& patches() const { return groups[2]; }
    /// The index of the first group of an element; -1: it is in no group.
    std::int32_t first_group(const Elements& block, std::size_t k) const {
        const Indices all = groups_of(block, k);
        return all.first == all.last ? -1 : *all.first;
    }
    /// The indices of all groups of an element.
    Indices groups_of(const Elements& block, std::size_t k) const;
    /// The blocks of these dimensions, numbered from one to the next.
    std::vector<NumberedElements> numbered(int lowest, int highest = 3) const;
    /// The lowest dimension of elements to be written, where a format allows `below` less than the highest one. Lines
    /// on CAD edges are not written to formats of solvers; lines of another program's mesh are.
    int lowest(int below) const { return is_given() ? std::max(1, dimension() - below) : 2; }
};

/// The elements of a group.
struct Members {
    std::string name;
    std::vector<std::pair<const NumberedElements*, std::int32_t>> elements;
    std::vector<std::int32_t> nodes;  ///< ascending: of its elements that are not volumes
};

/// The elements of these blocks by their first groups; those without a group form "others" at the end. For the mesh of
/// another program empty groups are left out.
std::vector<Members> divided(const ExportMesh& mesh, const std::vector<NumberedElements>& numbered);

/// The groups of faces, then those of volumes; for the mesh of another program all groups.
std::vector<Members> members_of(const ExportMesh& mesh, const std::vector<NumberedElements>& numbered);

/// Property numbers, from 1, by which solvers know groups: an element has the number of its first group. For the mesh
/// of another program only groups that are the first of some element are numbered.
class Properties {
  public:
    Properties(const ExportMesh& mesh, const std::vector<NumberedElements>& blocks);
    std::size_t of(const Elements& block, std::size_t k) const { return number_[slot_of(block, k)]; }
    const std::vector<std::string>& names() const { return names_; }  ///< entry i is property i + 1

  private:
    std::size_t slot_of(const Elements& block, std::size_t k) const;

    const ExportMesh& mesh_;
    std::vector<std::size_t> number_;  ///< by slot: groups of lines, lines without a group; likewise faces and solids
    std::vector<std::string> names_;
};

/// The mesh with its patches; without any all triangles are one patch, "Surface".
/// @throws InvalidInput for a mesh that require_valid refuses, and for patches that do not fit it
ExportMesh exported(const TriangleMesh& mesh, const Patches& patches = {}, double scale = 1.0);

/// Names the patches of the triangles, the last block of dimension 2, in a mesh that is complete but for these names.
/// @throws InvalidInput where they do not fit
void set_patches(ExportMesh& mesh, const Patches& patches);

/// Names the groups of the mesh of another program, which is complete but for these names.
/// @param groups  the names, each with rows of blocks: (index of the block, elements of it)
/// @throws std::out_of_range for blocks and rows that there are not
using NamedRows = std::pair<std::string, std::vector<std::pair<std::size_t, std::vector<std::int32_t>>>>;
void set_groups(ExportMesh& mesh, const std::vector<NamedRows>& groups);

/// FreeCAD's name of a CAD entity: "Face7" of (2, 6).
std::string entity_name(int dimension, int index);

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace mq::mesh {

using Triangle = std::array<std::int32_t, 3>;

/// True when the triangle names the same vertex twice.
inline bool is_collapsed(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// The entity on which a vertex lies: dimension 0 node, 1 edge, 2 face; index as in geometry::Entity. (-1, -1) unknown.
using VertexEntity = std::array<std::int32_t, 2>;

/// A plain indexed triangle mesh: the result of every algorithm, and the input of every check.
struct TriangleMesh {
    Vec3 origin = Vec3::Zero();                ///< origin of the local frame, mm
    std::vector<Vec3> vertices;                ///< relative to origin; every value is a single-precision number
    std::vector<Triangle> triangles;           ///< oriented outward
    std::vector<std::int32_t> triangle_face;   ///< CAD face of each triangle; empty when the mesh has no CAD
    std::vector<VertexEntity> vertex_entity;   ///< entity of each vertex; empty when the mesh has no CAD
    std::vector<std::int32_t> triangle_solid;  ///< solid that each triangle bounds; -1: none; empty without CAD
    /// The triangle of another solid that lies in the place of each one, the other way round; -1: none; empty where no
    /// solid shares a face with another.
    std::vector<std::int32_t> triangle_opposite;
    /// `triangle_face` and `vertex_entity` by the pieces of faces that were cut (geometry::Topology::parts_of); empty
    /// where none is.
    std::vector<std::int32_t> triangle_piece;
    std::vector<VertexEntity> vertex_piece;
};

}  // namespace mq::mesh

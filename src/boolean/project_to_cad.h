// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "geometry/engine.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// An operand of a Boolean: the mesh that took part, and the geometry from which it was meshed.
struct CadOperand {
    const mesh::TriangleMesh* mesh = nullptr;
    std::shared_ptr<geometry::Model> model;            ///< none: the operand is nothing but a mesh
    const std::vector<std::int32_t>* faces = nullptr;  ///< face of the model for each triangle of the mesh
};

/// The counts of projecting the vertices that a Boolean made onto the faces of shapes.
struct CadProjection {
    std::size_t moved = 0;      ///< vertices that lie on the native surfaces now
    std::size_t reverted = 0;   ///< vertices that would have made a fault there
    std::size_t left = 0;       ///< vertices without a point of the surfaces within the limit
    double largest_move = 0.0;  ///< largest displacement, mm
};

/// Puts the vertices that a Boolean made onto the native surfaces of the operands they lie on: along the intersection
/// of two shapes onto both; where a shape meets a mesh, onto the surface within the mesh's plane; on an edge of a
/// shape, onto both its faces.
///
/// The nearest such point is found by Newton's method on all surfaces at once, with the least displacement each time.
/// Vertices of operands and of triangles that are an operand's own stay. A vertex stays, too, if its move would flip a
/// triangle or make triangles touch, cross or degenerate (see verify): no fault is added.
/// @param result   of the Boolean; its origin is that of the operands
/// @param source   of each triangle, as in BooleanResult::triangle_source
/// @param near     how far vertices may be from the meshes they lie on, mm
/// @param limit    no vertex moves farther, mm
/// @throws Cancelled
CadProjection project_to_cad(mesh::TriangleMesh& result, const std::vector<std::array<std::int32_t, 2>>& source,
                             const std::vector<CadOperand>& operands, geometry::Engine& engine, double near,
                             double limit, Progress& progress);

}  // namespace mq::boolean

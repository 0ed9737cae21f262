// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/boolean.h"
#include "boolean/input/operation.h"
#include "geometry/engine.h"
#include "triangulate/work_mesh/result.h"
#include "workflows/boolean_report.h"
#include "workflows/operands/mesh_operands.h"

namespace mq::workflows {

enum class BooleanMethod {
    Default,  ///< Exact; Uniform where the operands have no exact result
    Exact,    ///< exact arrangements (boolean/boolean.h)
    Uniform,  ///< layered depth images (layered_depth)
};

/// `report` of the base class holds the measured fields of `figures`.
struct BooleanSurface : triangulate::Result {
    BooleanReport figures;
    /// See boolean::BooleanResult::triangle_source.
    std::vector<std::array<std::int32_t, 2>> triangle_source;
    /// See boolean::BooleanResult::triangle_origin; equal to triangle_source for the method Uniform.
    std::vector<std::array<std::int32_t, 2>> triangle_origin;
    /// See offset::OffsetOptions::corner_normals; empty if none were requested (workflows::corner_normals).
    std::vector<Vec3> corner_normals;
};

/// Fills the fields that every report of a closed result has: measurements, notes and times, with those of the steps
/// before.
/// @param empty  the sentence for a result without triangles
void complete_report(BooleanSurface& surface, const WorkBefore& before, const Message& empty, Progress& progress);

/// A Boolean of operands in any frames: they are brought into one, the result is put onto the surfaces of the shapes,
/// as far as the tolerance allows, and measured.
///
/// The method Default falls back to Uniform on errors that mean that the geometry has no exact result: an operand that
/// no repair closes (boolean::OpenOperand), surfaces that bound no volumes or cannot be rounded (TopologyError). The
/// report names the method, and a note the reason. Other errors (options, meshes that are not valid, memory) are
/// raised.
/// @param engine  answers for the shapes; the method Uniform samples the faces of shapes, and uses meshes only to find
///     the faces that a ray meets
/// @throws InvalidInput for the option `full` with another method than Uniform
/// @throws as boolean::boolean and layered_depth::layered_depth_boolean; for the method Default the error of the exact
///     method, and of the uniform one if that failed, too.
BooleanSurface boolean_of_operands(geometry::Engine& engine, const std::vector<BooleanOperand>& operands,
                                   const boolean::Expression& expression, const boolean::BooleanOptions& options,
                                   BooleanMethod method, const WorkBefore& before, Progress& progress);

/// A Boolean of operands that may be shapes, which are meshed first: within a quarter of the tolerance, for the method
/// Uniform within a sixteenth, so that few rays pass between mesh and face. Where no tolerance is given, the resolution
/// divides Operands::divided_length (Uniform: the size), and meshes keep the volume of each shape to 0.2 %, too.
/// @throws as Operands::meshed, too
BooleanSurface boolean_of_operands(const Operands& operands, const boolean::Expression& expression,
                                   boolean::BooleanOptions options, BooleanMethod method, Progress& progress);

/// Gives each triangle of a result the CAD face of the operand's triangle of which it is a piece, -1 if it has none; no
/// faces at all if no operand has any.
/// @param operands  of the Boolean, in its order: all are made of one shape
void name_faces(BooleanSurface& result, const std::vector<const triangulate::Result*>& operands);

}  // namespace mq::workflows

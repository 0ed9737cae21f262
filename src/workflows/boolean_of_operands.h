// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "boolean/boolean.h"
#include "boolean/input/operation.h"
#include "geometry/engine.h"
#include "triangulate/work_mesh/result.h"
#include "workflows/boolean_report.h"

class TopoDS_Shape;

namespace mq::workflows {

enum class BooleanMethod {
    Exact,    ///< exact arrangements (boolean/boolean.h)
    Uniform,  ///< layered depth images, for two operands (boolean/layered_depth)
};

/// An operand: its mesh, and the shape from which it was meshed.
struct BooleanOperand {
    const triangulate::Result* surface = nullptr;
    bool round = false;                   ///< true: its coordinates may be rounded to single precision
    const TopoDS_Shape* shape = nullptr;  ///< null: the operand is nothing but a mesh
};

/// What was done before: stages, notes and processor time of reading and meshing the operands.
struct WorkBefore {
    StageTimes seconds;
    std::vector<std::string> notes;
    double cpu_seconds = 0.0;
    /// mm: how far what was done before may have moved surfaces; the bound that is reported includes it.
    double error_bound = 0.0;
    double tolerance = 0.0;  ///< mm: the tolerance for all of the work, where it is not that of the last step
};

/// `report` of the base class holds the measured fields of `figures`.
struct BooleanSurface : triangulate::Result {
    BooleanReport figures;
    /// See boolean::BooleanResult::triangle_source.
    std::vector<std::array<std::int32_t, 2>> triangle_source;
    /// See boolean::BooleanResult::triangle_origin; of the method Uniform the same as triangle_source.
    std::vector<std::array<std::int32_t, 2>> triangle_origin;
};

/// Fills what every report of a closed result has: measured fields, notes, times and what the work before adds.
/// @param empty  the sentence for a result without triangles
void complete_report(BooleanSurface& surface, const WorkBefore& before, const std::string& empty, Progress& progress);

/// A Boolean of operands in any frames: they are brought into one, the result is put onto the surfaces of the shapes,
/// as far as the tolerance allows, and measured.
/// @param engine  answers for the shapes; the method Uniform samples their faces, and takes only which of them a ray
///     meets from their meshes
/// @throws as boolean::boolean and boolean::layered_depth_boolean; InvalidInput for an option out of range, and for
///     other than two operands of the method Uniform.
BooleanSurface boolean_of_operands(geometry::Engine& engine, const std::vector<BooleanOperand>& operands,
                                   const boolean::Expression& expression, const boolean::BooleanOptions& options,
                                   BooleanMethod method, const WorkBefore& before, Progress& progress);

/// Gives a result's triangles the CAD faces of those triangles of its operands of which they are pieces, -1 where there
/// is none; nothing where no operand knows faces.
/// @param operands  of the Boolean, in its order: all are made of one shape
void name_faces(BooleanSurface& result, const std::vector<const triangulate::Result*>& operands);

}  // namespace mq::workflows

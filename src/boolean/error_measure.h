// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "boolean/exact_solid.h"
#include "boolean/input/operation.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// Operands of which vertices were moved before a result was made of them. Where it is far from other operands a piece
/// of a triangle is as far from the exact surface as it is from the triangle as that was: moves change no winding
/// number there. Samples are taken elsewhere only.
struct MovedOperands {
    /// For each triangle of the operands, all in one list in their order, its corners after the moves.
    std::vector<std::array<Vec3, 3>> triangles;
    /// For each triangle of the result the one in that list of which it is a piece; -1: not known.
    std::vector<std::int32_t> source;
    double reach = 0.0;  ///< mm, twice the largest move
};

/// How finely a result is measured, mm.
struct ErrorLimits {
    /// The spacing of samples on large triangles; no more are taken than some 100,000 beyond one for each triangle.
    double finest = 0.0;
    double enough = 0.0;  ///< distances up to this are not told apart
    /// Where the exact solid, or a gap in it, is thinner than this, nobody looks for its surface in the result.
    double thinnest = 0.0;
};

/// The largest distances found between a result and the exact Boolean of its operands, mm.
struct MeasuredError {
    double to_exact = 0.0;    ///< from points of the result to the exact surface
    double from_exact = 0.0;  ///< from points of the exact surface to the result
    double spacing = 0.0;     ///< sampled triangles have a point within this distance of each of theirs, mm

    double largest() const { return to_exact > from_exact ? to_exact : from_exact; }
};

/// Measures how far a result is from the exact Boolean of its operands, both ways, by points of triangles that are not
/// an operand's own. The exact surface is not made: a point of space belongs to the exact solid or not by the winding
/// numbers of the operands there, counted along rays.
///
/// From the result: its vertices, and points inside of triangles. Where a point of the exact solid and one outside of
/// it are at a distance d at most, the surface between them is within d too; the point behind the nearest triangles of
/// operands, and behind the curves and corners in which two or three of these meet, is sought that is on another side.
/// So the distance of each point is bounded from above, whatever the search finds.
///
/// From the exact surface: points of the operands' triangles on which the exact solid is on one side only, and their
/// distances from the nearest triangle of the result.
/// @param own      for each triangle of the result whether it is an operand's own, and not sampled; empty: none is
/// @param moved    null: the operands have not been moved
/// @throws Cancelled
MeasuredError measure_error(const std::vector<EnclosedOperand>& operands, const Expression& expression,
                            const mesh::TriangleMesh& result, const std::vector<char>& own, const ErrorLimits& limits,
                            const Progress& progress, const MovedOperands* moved = nullptr);

}  // namespace mq::boolean

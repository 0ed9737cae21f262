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

/// Operands whose vertices were moved before a result was made of them. If a piece of a triangle is far from the other
/// operands, its distance from the exact surface is its distance from the unmoved triangle: moves change no winding
/// number there. Only the other pieces are sampled.
struct MovedOperands {
    /// For each triangle of the operands, in one list of all operands, its corners after the moves.
    std::vector<std::array<Vec3, 3>> triangles;
    /// For each triangle of the result the triangle in that list of which it is a piece; -1: not known.
    std::vector<std::int32_t> source;
    double reach = 0.0;  ///< mm, twice the largest move
};

/// The resolution at which a result is measured, mm.
struct ErrorLimits {
    /// The spacing of samples on large triangles; no more are taken than some 100,000 beyond one for each triangle.
    double finest = 0.0;
    double enough = 0.0;  ///< distances up to this are not told apart
    /// Surfaces of the exact solid are not searched in the result if the solid, or a gap in it, is thinner than this.
    double thinnest = 0.0;
};

/// The largest distances found between a result and the exact Boolean of its operands, mm.
struct MeasuredError {
    double to_exact = 0.0;    ///< from points of the result to the exact surface
    double from_exact = 0.0;  ///< from points of the exact surface to the result
    double spacing = 0.0;     ///< mm: every point of a sampled triangle has a sample within this distance

    double largest() const { return to_exact > from_exact ? to_exact : from_exact; }
};

/// Measures how far a result is from the exact Boolean of its operands, in both directions, by points of triangles that
/// are not unchanged triangles of operands. The exact surface is not constructed: the winding numbers of the operands
/// at a point, counted along rays, tell whether the point belongs to the exact solid.
/// From the result: its vertices, and points inside of its triangles. If a point has one point inside of the exact
/// solid and one outside of it within a distance d, the exact surface is within d, too. So the search for each point
/// looks for a point on another side: behind the nearest triangles of operands, and behind the curves and corners in
/// which two or three of these meet. This bounds the distance of each point from above, whatever the search finds.
/// From the exact surface: points of the operands' triangles with the exact solid on one side only, and their distances
/// from the nearest triangle of the result.
/// @param own      for each triangle of the result whether it is an unchanged triangle of an operand, which is not
/// sampled; empty: none is
/// @param moved    null: the operands were not moved
/// @throws Cancelled
MeasuredError measure_error(const std::vector<EnclosedOperand>& operands, const Expression& expression,
                            const mesh::TriangleMesh& result, const std::vector<char>& own, const ErrorLimits& limits,
                            const Progress& progress, const MovedOperands* moved = nullptr);

}  // namespace mq::boolean

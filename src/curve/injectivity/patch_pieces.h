// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "base/vec.h"
#include "elements/bezier/simplex_lattice.h"
#include "elements/bezier/sub_simplex.h"

namespace mq::curve {

/// A sub-triangle of a Bezier triangle that results from halving; it is a Bezier triangle itself.
struct PatchPiece {
    PatchPiece(const elements::Lattice& lattice, std::vector<Vec3> points, const elements::SimplexPart& in_patch);

    std::vector<Vec3> control;
    std::array<Vec3, 3> corners;
    elements::SimplexPart
        part;           ///< its corners in the whole patch; sums of powers of two, so that equal places are equal
    Box box;            ///< holds the control points
    double bend = 0.0;  ///< mm: largest distance between points of equal parameters of the piece and of the flat
                        ///< triangle of its corners
    double size = 0.0;  ///< mm: diagonal of the box
    /// By edge, numbered by the opposite corner: the first of the two pieces that halving it gives; -1: not halved.
    std::array<std::int32_t, 3> halves{-1, -1, -1};
};

/// The pieces of one Bezier triangle, each computed once; number 0 is the whole triangle.
class PatchPieces {
  public:
    PatchPieces(const elements::Lattice& lattice, const std::vector<Vec3>& control);

    const elements::Lattice& lattice() const { return *lattice_; }
    const PatchPiece& operator[](std::int32_t piece) const { return pieces_[static_cast<std::size_t>(piece)]; }

    /// Halves a piece at the middle of the edge between two of its corners. @return the number of the half that keeps
    /// the corner with the lower number; the other half has the next number
    std::int32_t halve(std::int32_t piece, int a, int b);
    /// Halves a piece at the edge that is longest in the parameters, so that pieces keep their shapes.
    std::int32_t halve(std::int32_t piece);

  private:
    const elements::Lattice* lattice_;
    std::deque<PatchPiece> pieces_;
};

/// Adds the transversals: differences of control points that lead from the edge opposite to a corner towards that
/// corner. Each point of the patch is a point of the edge plus a sum of transversals with positive weights.
void add_transversals(const elements::Lattice& lattice, const std::vector<Vec3>& control, int corner, double sign,
                      std::vector<Vec3>& vectors);

/// Adds the differences of the control points of the edge from corner a to corner b.
void add_tangents(const elements::Lattice& lattice, const std::vector<Vec3>& control, int a, int b, double sign,
                  std::vector<Vec3>& vectors);

}  // namespace mq::curve

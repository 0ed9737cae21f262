// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "base/vec.h"
#include "curve/bezier/simplex_lattice.h"
#include "curve/bezier/sub_simplex.h"

namespace mq::curve {

/// A sub-triangle of a Bezier triangle that halving made: a Bezier triangle itself.
struct PatchPiece {
    PatchPiece(const Lattice& lattice, std::vector<Vec3> points, const SimplexPart& in_patch);

    std::vector<Vec3> control;
    std::array<Vec3, 3> corners;
    SimplexPart part;   ///< its corners in the whole patch; sums of powers of two, so that equal places are equal
    Box box;            ///< holds the control points
    double bend = 0.0;  ///< largest distance, mm, between points of equal parameters of it and of its straight triangle
    double size = 0.0;  ///< diagonal of the box, mm
    /// By edge, which goes by the corner opposite: the first of the two pieces that its middle makes; -1: none yet.
    std::array<std::int32_t, 3> halves{-1, -1, -1};
};

/// The pieces of one Bezier triangle, each made once; number 0 is the whole.
class PatchPieces {
  public:
    PatchPieces(const Lattice& lattice, const std::vector<Vec3>& control);

    const Lattice& lattice() const { return *lattice_; }
    const PatchPiece& operator[](std::int32_t piece) const { return pieces_[static_cast<std::size_t>(piece)]; }

    /// Halves a piece at the middle of the edge between two of its corners. @return the number of the half that keeps
    /// the lower of them; the next number is that of the other
    std::int32_t halve(std::int32_t piece, int a, int b);
    /// The same at the edge that is longest in the parameters, so that pieces keep their shapes.
    std::int32_t halve(std::int32_t piece);

  private:
    const Lattice* lattice_;
    std::deque<PatchPiece> pieces_;
};

/// The differences of the control points along which the patch runs from the edge opposite to a corner towards that
/// corner: each of its points is one of the edge plus a sum of them with positive weights.
void add_transversals(const Lattice& lattice, const std::vector<Vec3>& control, int corner, double sign,
                      std::vector<Vec3>& vectors);

/// The differences of the control points of the edge from corner a to corner b.
void add_tangents(const Lattice& lattice, const std::vector<Vec3>& control, int a, int b, double sign,
                  std::vector<Vec3>& vectors);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>

#include "base/vec.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::mesh {

/// A convex piece of a triangle.
struct Piece {
    static constexpr std::size_t kMostCorners = 12;
    static constexpr std::size_t kMostCuts = 3;  ///< in turn, each of which may add a corner
    std::array<Vec3, kMostCorners> corners;      ///< the first `count` of them
    std::size_t count = 0;
    int halvings = 0;

    void add(const Vec3& p) { corners[count++] = p; }
    bool has_many() const { return count + kMostCuts > kMostCorners; }
    Vec3 centre() const;
    /// The distance of the farthest corner from a point.
    double farthest_from(const Vec3& p) const;
    /// An upper bound for the distance of its points from a triangle: that of its corners.
    double farthest_from(const Corners& t) const;
};

/// A plane, with the side in front of it.
struct Plane {
    Vec3 on = Vec3::Zero();
    Vec3 normal = Vec3::Zero();

    double height(const Vec3& p) const { return normal.dot(p - on); }
};

/// The planes upright on the sides of a triangle; the triangle is behind them.
std::array<Plane, 3> upright(const Corners& t);

/// The parts of a piece behind a plane and in front of it; one of them has no corners if the plane does not cross it.
/// Corners next to the plane count as on it, so that no parts without extent come about.
std::array<Piece, 2> cut(const Piece& piece, const Plane& plane);

/// The halves of a piece across its longest side, or of one with many corners along a diagonal.
std::array<Piece, 2> halves(const Piece& piece);

}  // namespace mq::mesh

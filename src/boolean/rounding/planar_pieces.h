// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/corner_table.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

using mesh::Triangle;

/// Divides a triangle along points near its edges and its inside.
///
/// The pieces are those of the points' feet in the triangle's plane, with short diagonals (swapped as in Lawson 1977):
/// the edges of a thin triangle's pieces then go across it, and seldom pass near points other than their ends.
/// Whatever the rounding, the pieces have the triangle's border, with the points on it, as their border.
class PlanarPieces {
  public:
    /// @param corners  the triangle, counter-clockwise; its corners are not on one line
    PlanarPieces(const std::vector<Vec3>& vertices, const Triangle& corners);

    /// Adds vertex `w` on edge k, which runs from corner k, at the fraction `s` of the edge, 0 < s < 1. Those of an
    /// edge come in their order along it.
    void add_on_edge(std::size_t k, double s, std::int32_t w);
    /// Adds vertex `w` in the inside.
    void add_inside(std::int32_t w);

    /// The pieces by vertices. A vertex that is added to several edges is there several times: pieces may name a vertex
    /// twice.
    std::vector<Triangle> run();

  private:
    using Vec2 = Eigen::Vector2d;
    /// A piece: indices of points, and the half-edge 3 piece + k on the other side of edge k, -1 on the border.
    struct Piece {
        std::array<int, 3> point;
        std::array<int, 3> twin;
    };

    Vec2 in_plane(const Vec3& p) const { return {(p - origin_).dot(along_), (p - origin_).dot(aside_)}; }
    const Vec2& place(int point) const { return place_[static_cast<std::size_t>(point)]; }
    Piece& piece(int half) { return pieces_[static_cast<std::size_t>(half / 3)]; }
    const Piece& piece(int half) const { return pieces_[static_cast<std::size_t>(half / 3)]; }
    int origin(int half) const { return piece(half).point[static_cast<std::size_t>(half % 3)]; }
    int twin(int half) const { return piece(half).twin[static_cast<std::size_t>(half % 3)]; }
    static int next(int half) { return mesh::next_corner(half); }
    static int prev(int half) { return mesh::previous_corner(half); }
    double area(int a, int b, int c) const;
    void link(int half, int other);
    int new_piece(int a, int b, int c);
    int split_edge(int half, int point);
    void split_inside(int point);
    bool should_flip(int half) const;
    void flip(int half);
    void improve();

    const std::vector<Vec3>& vertices_;
    Vec3 origin_;
    Vec3 along_;
    Vec3 aside_;
    double flat_ = 0.0;  ///< areas up to this are rounding error
    std::vector<Vec2> place_;
    std::vector<std::int32_t> vertex_;  ///< the vertex of each point
    std::array<std::vector<int>, 3> on_edge_;
    std::vector<int> inside_;
    std::vector<Piece> pieces_;
};

}  // namespace mq::boolean

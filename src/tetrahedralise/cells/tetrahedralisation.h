// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/predicates.h"
#include "base/vec.h"

namespace mq::tetrahedralise {

/// A tetrahedron of positive volume with its neighbours: n[i] lies across the face opposite v[i], -1 where there is
/// none.
struct Cell {
    std::array<int, 4> v{-1, -1, -1, -1};
    std::array<int, 4> n{-1, -1, -1, -1};
};

/// The face opposite v[i], from which v[i] is seen on the positive side.
inline constexpr int kFaceOf[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};

/// The cells around an edge p-q: cell i has the corners p, q, x[i], x[i + 1], in positive order.
struct EdgeRing {
    std::vector<int> cells;
    std::vector<int> x;
};

/// Tetrahedra that fit together face to face, under local changes. Numbers of removed cells are used again.
class Tetrahedralisation {
  public:
    std::vector<Vec3> points;
    std::vector<Cell> cells;

    bool alive(int cell) const { return cells[cell].v[0] >= 0; }
    const Vec3& point(int v) const { return points[v]; }
    int orient(int a, int b, int c, int d) const { return orient3d(points[a], points[b], points[c], points[d]); }
    int add_point(const Vec3& point);
    /// Moves a point without a change of topology; the caller has checked the cells around.
    void move_point(int v, const Vec3& point) { points[v] = point; }

    /// Removes cells and puts others into the space that they leave. New faces that meet no other become the boundary,
    /// as do faces of cells that stay where nothing new is added.
    /// @param created gets the numbers of the new cells, in their order
    void replace(const std::vector<int>& removed, const std::vector<std::array<int, 4>>& added,
                 std::vector<int>& created);

    /// A cell with this vertex, or -1.
    int cell_at(int v) const { return at_vertex_[v]; }
    /// All cells with this vertex.
    void star(int v, std::vector<int>& found) const { star(v, found, seen_); }
    /// All cells with this vertex; threads that search in parallel pass their own scratch memory.
    void star(int v, std::vector<int>& found, std::vector<char>& seen) const;
    /// A cell with this edge, or -1.
    int cell_with(int a, int b) const;
    /// A cell with this face, or -1.
    int cell_with(int a, int b, int c) const;
    /// @return false where there is no such edge, or where it lies on the boundary.
    bool ring(int a, int b, EdgeRing& found) const;
    /// @param first  a known cell with the edge
    bool ring(int first, int a, int b, EdgeRing& found) const;

    int index_of(int cell, int v) const {
        const Cell& c = cells[cell];
        return c.v[0] == v ? 0 : c.v[1] == v ? 1 : c.v[2] == v ? 2 : c.v[3] == v ? 3 : -1;
    }
    bool has(int cell, int v) const { return index_of(cell, v) >= 0; }
    /// The face of `cell` that it shares with its neighbour `other`.
    int face_towards(int cell, int other) const {
        const Cell& c = cells[cell];
        return c.n[0] == other ? 0 : c.n[1] == other ? 1 : c.n[2] == other ? 2 : 3;
    }

  private:
    struct Open {
        std::array<int, 3> key;
        int cell;
        int face;
        std::uint32_t round = 0;
    };

    int new_cell(const std::array<int, 4>& v);
    void prepare_table(std::size_t faces);
    void meet(int cell, int face);

    std::vector<int> at_vertex_;
    std::vector<int> free_;
    std::vector<Open> table_;
    std::uint32_t round_ = 0;
    std::vector<char> goes_;  // by cell: whether it is being removed
    mutable std::vector<char> seen_;
    mutable std::vector<int> queue_;
};

}  // namespace mq::tetrahedralise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "mesh/simplex_stars.h"

namespace mq::offset {

/// Tetrahedra that fill a box and are divided locally, without hanging nodes: the Kuhn triangulation of cubes, bisected
/// at longest edges (Rivara 1991, Local modification of meshes for adaptive and/or multigrid finite-element methods),
/// which for this triangulation is Maubach's bisection with three shapes of cells. An edge can also be divided at any
/// other point, which makes other shapes.
class BisectedLattice {
  public:
    using Cell = std::array<std::int32_t, 4>;  ///< its nodes

    /// @param box  the box that the lattice fills at least
    /// @param side  mm: side of the cubes
    /// @param finest  mm: edges up to this length are not divided
    BisectedLattice(const Box& box, double side, double finest);

    std::size_t node_count() const { return nodes_.size(); }
    /// Number of all cells, including those that were divided.
    std::size_t cell_count() const { return cells_.size(); }
    bool is_divided(std::size_t cell) const { return divided_[cell] != 0; }
    const Cell& cell(std::size_t index) const { return cells_[index]; }
    const Vec3& at(std::int32_t node) const { return nodes_[static_cast<std::size_t>(node)]; }
    std::array<Vec3, 4> corners(const Cell& cell) const { return {at(cell[0]), at(cell[1]), at(cell[2]), at(cell[3])}; }
    /// Whether a cell has an edge that may be divided.
    bool is_divisible(const Cell& cell) const;
    /// Divides a cell at its longest edge, unless it is divided already. Cells around that edge that have a longer edge
    /// are divided first.
    void divide(std::size_t cell);
    /// Divides all cells around an edge at one of its points, which becomes a node. Does nothing if there is no such
    /// edge.
    void divide_edge(std::int32_t a, std::int32_t b, const Vec3& point);

  private:
    std::int32_t add_node(const Vec3& place);
    void add(const Cell& cell);
    void bisect(std::size_t cell, std::int32_t a, std::int32_t b, std::int32_t middle);
    std::array<std::int32_t, 2> longest_edge(const Cell& cell) const;

    double finest_;
    std::vector<Vec3> nodes_;
    std::vector<Cell> cells_;
    mesh::SimplexStars undivided_;
    std::vector<char> divided_;
};

}  // namespace mq::offset

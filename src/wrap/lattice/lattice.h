// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace mq::wrap {

/// A node of the lattice: three even or three odd numbers, in half sides of its cubes.
using Node = std::array<std::int32_t, 3>;

/// The body-centred cubic lattice: the corners and the centres of cubes. All its Delaunay tetrahedra are congruent,
/// with two edges as long as a cube's side and four edges of sqrt(3)/2 of the side (Labelle and Shewchuk 2007,
/// Isosurface Stuffing, section 3.1).
///
/// Nodes are stored in blocks of 4 x 4 x 4 cubes.
class Lattice {
  public:
    static constexpr int kBlockNodes = 128;  ///< nodes of a block
    static constexpr int kBits = 3;
    static constexpr std::int32_t kAcross = 1 << kBits;  ///< half sides along a block

    /// @param box  the box that the lattice covers, with a margin around it
    /// @param side  mm, of a cube: the longest edge of a tetrahedron
    Lattice(const Box& box, double margin, double side);

    double side() const { return side_; }
    Vec3 at(const Node& node) const { return origin_ + 0.5 * side_ * Vec3(node[0], node[1], node[2]); }
    /// Number of blocks along each axis.
    const std::array<std::int32_t, 3>& blocks() const { return blocks_; }
    std::size_t block_count() const {
        return static_cast<std::size_t>(blocks_[0]) * static_cast<std::size_t>(blocks_[1]) *
               static_cast<std::size_t>(blocks_[2]);
    }
    bool contains(const Node& node) const {
        return is_below(node[0], blocks_[0]) && is_below(node[1], blocks_[1]) && is_below(node[2], blocks_[2]);
    }
    /// The block of a node, and its index in the block.
    std::size_t block_of(const Node& node) const {
        return block_index({node[0] >> kBits, node[1] >> kBits, node[2] >> kBits});
    }
    std::size_t block_index(const std::array<std::int32_t, 3>& block) const {
        return (static_cast<std::size_t>(block[0]) * static_cast<std::size_t>(blocks_[1]) +
                static_cast<std::size_t>(block[1])) *
                   static_cast<std::size_t>(blocks_[2]) +
               static_cast<std::size_t>(block[2]);
    }
    std::array<std::int32_t, 3> block_at(std::size_t index) const;
    static int place_in_block(const Node& node) {
        const int odd = node[0] & 1;
        return odd * 64 + ((node[0] & 7) >> 1) * 16 + ((node[1] & 7) >> 1) * 4 + ((node[2] & 7) >> 1);
    }
    /// The node with an index in a block.
    static Node node_at(const std::array<std::int32_t, 3>& block, int place);
    /// Most half sides along each axis for which keys are unique.
    static constexpr std::int32_t kMostAcross = 1 << 20;
    bool has_keys() const { return kAcross * std::max({blocks_[0], blocks_[1], blocks_[2]}) <= kMostAcross; }
    /// A number for a node, ascending along the axes; see has_keys.
    static std::uint64_t key(const Node& node) {
        return (static_cast<std::uint64_t>(node[0]) << 40) | (static_cast<std::uint64_t>(node[1]) << 20) |
               static_cast<std::uint64_t>(node[2]);
    }

    /// The 14 steps along edges to neighbours; step k + 7 is opposite to step k.
    static const std::array<Node, 14>& steps();
    /// Length of the edge of a step, mm.
    double length_of_step(int k) const { return k % 7 < 3 ? side_ : kDiagonal * side_; }
    /// The step from one node to a neighbour.
    static int step_between(const Node& from, const Node& to);

  private:
    /// Whether a number is at least 0 and in one of the first blocks.
    static bool is_below(std::int32_t i, std::int32_t blocks) {
        return static_cast<std::uint32_t>(i) < static_cast<std::uint32_t>(kAcross * blocks);
    }

    static constexpr double kDiagonal = 0.8660254037844386;  // sqrt(3) / 2

    Vec3 origin_;
    double side_;
    std::array<std::int32_t, 3> blocks_{};
};

inline Node operator+(const Node& a, const Node& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// Calls visit(neighbour, step) for the neighbours that the lattice has.
template <typename Visit>
void for_each_neighbour(const Lattice& lattice, const Node& node, const Visit& visit) {
    for (int k = 0; k < 14; ++k) {
        const Node other = node + Lattice::steps()[static_cast<std::size_t>(k)];
        if (lattice.contains(other)) {
            visit(other, k);
        }
    }
}

/// visit(corners) for the four tetrahedra around the edge from a node along an axis, forward or back.
template <typename Visit>
void for_each_tetrahedron_around(const Node& node, int axis, int direction, const Visit& visit) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    Node other = node;
    other[axis] += 2 * direction;
    std::array<Node, 4> ring;
    for (int k = 0; k < 4; ++k) {
        Node& corner = ring[k];
        corner[axis] = node[axis] + direction;
        corner[u] = node[u] + (k == 0 || k == 3 ? 1 : -1);
        corner[v] = node[v] + (k < 2 ? 1 : -1);
    }
    for (int k = 0; k < 4; ++k) {
        visit(std::array<Node, 4>{node, other, ring[k], ring[(k + 1) % 4]});
    }
}

/// visit(corners) for the 24 tetrahedra at a node.
template <typename Visit>
void for_each_tetrahedron_at(const Node& node, const Visit& visit) {
    for (int axis = 0; axis < 3; ++axis) {
        for_each_tetrahedron_around(node, axis, 1, visit);
        for_each_tetrahedron_around(node, axis, -1, visit);
    }
}

}  // namespace mq::wrap

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// The tetrahedra of the lattice, of larger cubes where the wrap is plane: the cubes of a block are joined to one, or
/// eight of them to one. Sides of cubes that share an edge differ by a factor of 2 at most. Cubes of one side share the
/// tetrahedra of the body-centred cubic lattice of that side, bisected at edges with smaller cubes; between a cube and
/// a larger one there are halves of pyramids (Labelle and Shewchuk 2007, Isosurface Stuffing, section 3.2).
///
/// A larger cube is plane: the input in it, and in the margin of half its side around it, lies in one plane and belongs
/// to one patch; its nodes are all on one side of the wrap, or exactly those on one side of the plane are outside;
/// edges between outside and inside meet the input; no node is moved or in a sheet. Its tetrahedra lie within that
/// margin, so that the wrap crosses each of their edges at most once, in that plane.
class GradedCells {
  public:
    /// @param patch  of each triangle of the input; empty: all are of one
    /// @throws Cancelled
    GradedCells(const NodeStates& states, const std::vector<std::int32_t>& patch, const Progress& progress);

    /// The blocks with cells that the wrap may cross, and some more.
    const std::vector<std::array<std::int32_t, 3>>& blocks() const { return blocks_; }

    /// visit(corners) for the tetrahedra at the cubes of a block; over all blocks each tetrahedron is visited once.
    template <typename Visit>
    void for_each_tetrahedron(const std::array<std::int32_t, 3>& block, const Visit& visit) const {
        const Cube low{kCubes * block[0], kCubes * block[1], kCubes * block[2]};
        for_each_leaf(low, [&](const Cube& leaf, std::int32_t across) { add_leaf(leaf, across, visit); });
    }

  private:
    /// The low corner of a cube, in sides of the cubes of the lattice.
    using Cube = std::array<std::int32_t, 3>;
    static constexpr std::int32_t kCubes = Lattice::kAcross / 2;  ///< along a block
    static constexpr std::int32_t kHalf = kCubes / 2;             ///< along one of its eighths

    std::size_t block_of(const Cube& cube) const {
        return states_.lattice().block_index({cube[0] / kCubes, cube[1] / kCubes, cube[2] / kCubes});
    }
    static int eighth_of(const Cube& cube) {
        return cube[0] / kHalf % 2 + 2 * (cube[1] / kHalf % 2) + 4 * (cube[2] / kHalf % 2);
    }
    bool contains(const Cube& cube) const;
    /// The side of the cube in which a cube of the lattice is.
    std::int32_t across_at(const Cube& cube) const {
        const std::size_t block = block_of(cube);
        return whole_[block] != 0 ? kCubes : (single_[block] >> eighth_of(cube) & 1U) != 0 ? 1 : kHalf;
    }
    bool is_plane(const Cube& low, std::int32_t across) const;
    void divide_beside(const std::array<std::int32_t, 3>& block);
    void add_neighbours(const std::array<std::int32_t, 3>& block, std::vector<char>& known);

    template <typename Visit>
    void for_each_leaf(const Cube& low, const Visit& visit) const {
        const std::size_t block = block_of(low);
        if (whole_[block] != 0) {
            visit(low, kCubes);
            return;
        }
        for (int k = 0; k < 8; ++k) {
            const Cube eighth{low[0] + kHalf * (k & 1), low[1] + kHalf * (k >> 1 & 1), low[2] + kHalf * (k >> 2)};
            if ((single_[block] >> k & 1U) == 0) {
                visit(eighth, kHalf);
                continue;
            }
            for (int i = 0; i < 8; ++i) {
                visit(Cube{eighth[0] + (i & 1), eighth[1] + (i >> 1 & 1), eighth[2] + (i >> 2)}, 1);
            }
        }
    }

    static Node centre_of(const Cube& low, std::int32_t across) {
        return {2 * low[0] + across, 2 * low[1] + across, 2 * low[2] + across};
    }
    /// The corners of the face of a cube that looks along an axis, or against it, around it.
    static std::array<Node, 4> face_of(const Cube& low, std::int32_t across, int axis, int way) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        std::array<Node, 4> corners;
        for (std::size_t k = 0; k < 4; ++k) {
            corners[k] = {2 * low[0], 2 * low[1], 2 * low[2]};
            corners[k][axis] += way > 0 ? 2 * across : 0;
            corners[k][u] += k == 1 || k == 2 ? 2 * across : 0;
            corners[k][v] += k >= 2 ? 2 * across : 0;
        }
        return corners;
    }

    /// The tetrahedra between a cube and those of its side above it along each axis, and the larger ones around it.
    template <typename Visit>
    void add_leaf(const Cube& low, std::int32_t across, const Visit& visit) const {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int way : {-1, 1}) {
                Cube beside = low;
                beside[axis] += way > 0 ? across : -1;
                if (!contains(beside)) {
                    continue;
                }
                const std::int32_t other = across_at(beside);
                if (other == across && way > 0) {
                    add_between_equal(low, across, axis, visit);
                } else if (other > across) {
                    add_beside_larger(low, across, axis, way, beside, visit);
                }
            }
        }
    }
    template <typename Visit>
    void add_between_equal(const Cube& low, std::int32_t across, int axis, const Visit& visit) const {
        const Node centre = centre_of(low, across);
        Node other = centre;
        other[axis] += 2 * across;
        const std::array<Node, 4> corners = face_of(low, across, axis, 1);
        for (std::size_t k = 0; k < 4; ++k) {
            const Node& from = corners[k];
            const Node& to = corners[(k + 1) % 4];
            if (is_divided(low, across, axis, static_cast<int>(k))) {
                const Node middle{(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2};
                visit(std::array<Node, 4>{centre, other, from, middle});
                visit(std::array<Node, 4>{centre, other, middle, to});
            } else {
                visit(std::array<Node, 4>{centre, other, from, to});
            }
        }
    }
    /// Whether smaller cubes are at an edge of the face between a cube and the one above it.
    /// @param k  the edge, as in face_of
    bool is_divided(const Cube& low, std::int32_t across, int axis, int k) const {
        if (across == 1) {
            return false;
        }
        Cube beside = low;
        beside[k % 2 == 0 ? (axis + 2) % 3 : (axis + 1) % 3] += k == 1 || k == 2 ? across : -1;
        Cube above = beside;
        above[axis] += across;
        return contains(beside) && (across_at(beside) < across || across_at(above) < across);
    }
    template <typename Visit>
    void add_beside_larger(const Cube& low, std::int32_t across, int axis, int way, const Cube& beside,
                           const Visit& visit) const {
        const Node centre = centre_of(low, across);
        Cube its = beside;
        for (std::int32_t& i : its) {
            i -= i % (2 * across);
        }
        const Node other = centre_of(its, 2 * across);
        const std::array<Node, 4> corners = face_of(low, across, axis, way);
        // The middle of the larger face: from there all four smaller ones are halved alike.
        std::size_t first = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const bool is_middle = corners[k][(axis + 1) % 3] == other[(axis + 1) % 3] &&
                                   corners[k][(axis + 2) % 3] == other[(axis + 2) % 3];
            first = is_middle ? k : first;
        }
        const auto corner = [&](std::size_t k) { return corners[(first + k) % 4]; };
        for (const Node& apex : {centre, other}) {
            visit(std::array<Node, 4>{apex, corner(0), corner(1), corner(2)});
            visit(std::array<Node, 4>{apex, corner(0), corner(2), corner(3)});
        }
    }

    const NodeStates& states_;
    const std::vector<std::int32_t>& patch_;
    std::vector<char> whole_;           ///< for each block of the lattice: it is one cube
    std::vector<std::uint8_t> single_;  ///< bit k: the eighth k of the block is single cubes, if it is not whole
    std::vector<std::array<std::int32_t, 3>> blocks_;
};

}  // namespace mq::wrap

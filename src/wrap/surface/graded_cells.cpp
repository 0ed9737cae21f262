// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/surface/graded_cells.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/parallel.h"

namespace mq::wrap {

namespace {

using Corners = std::array<Vec3, 3>;

/// Whether a triangle and a box have points in common, or nearly so (separating axes: Akenine-Moeller 2001).
bool meets_box(const Corners& corners, const Vec3& centre, double half) {
    const auto is_parted = [&](const Vec3& axis) {
        const double reach = (1.0 + 1e-9) * half * axis.cwiseAbs().sum();
        const double a = axis.dot(corners[0] - centre);
        const double b = axis.dot(corners[1] - centre);
        const double c = axis.dot(corners[2] - centre);
        return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
    };
    const std::array<Vec3, 3> sides{corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
    if (is_parted(sides[0].cross(sides[1]))) {
        return false;
    }
    for (int k = 0; k < 3; ++k) {
        if (is_parted(Vec3::Unit(k)) || std::any_of(sides.begin(), sides.end(), [&](const Vec3& side) {
                return is_parted(side.cross(Vec3::Unit(k)));
            })) {
            return false;
        }
    }
    return true;
}

struct Plane {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    std::int32_t triangle = -1;  ///< -1: there is none

    double height(const Vec3& p) const { return normal.dot(p - point); }
};

/// The plane of all triangles in a box, within a slack; nothing where there is none, or they are not of one patch.
std::optional<Plane> plane_in(const InputSurface& surface, const std::vector<std::int32_t>& patch, const Vec3& centre,
                              double half, double slack) {
    Plane plane;
    bool holds = true;
    const Box box{centre - Vec3::Constant(half), centre + Vec3::Constant(half)};
    surface.tree.for_each_in_box(box, [&](std::int32_t t) {
        const mesh::Triangle& c = surface.triangles[static_cast<std::size_t>(t)];
        const Corners corners{surface.points[c[0]], surface.points[c[1]], surface.points[c[2]]};
        if (!meets_box(corners, centre, half)) {
            return true;
        }
        if (plane.triangle < 0) {
            plane = {corners[0], surface.normal(t), t};
            holds = plane.normal != Vec3::Zero();
        } else {
            const auto is_in = [&](const Vec3& p) { return std::abs(plane.height(p)) <= slack; };
            holds = std::all_of(corners.begin(), corners.end(), is_in) &&
                    (patch.empty() ||
                     patch[static_cast<std::size_t>(t)] == patch[static_cast<std::size_t>(plane.triangle)]);
        }
        return holds;
    });
    return holds ? std::optional<Plane>(plane) : std::nullopt;
}

/// Calls visit(node) for the nodes in a closed cube. @return whether all calls returned true; the first false ends it
template <typename Visit>
bool all_nodes(const Node& low, std::int32_t across, const Visit& visit) {
    for (std::int32_t x = 0; x <= 2 * across; ++x) {
        for (std::int32_t y = x & 1; y <= 2 * across; y += 2) {
            for (std::int32_t z = x & 1; z <= 2 * across; z += 2) {
                if (!visit(Node{low[0] + x, low[1] + y, low[2] + z})) {
                    return false;
                }
            }
        }
    }
    return true;
}

}  // namespace

GradedCells::GradedCells(const NodeStates& states, const std::vector<std::int32_t>& patch, const Progress& progress)
    : states_(states),
      patch_(patch),
      whole_(states.lattice().block_count(), 1),
      single_(states.lattice().block_count(), 0),
      blocks_(states.blocks()) {
    for_chunks(static_cast<int>(states.blocks().size()), [&](int k) {
        progress.check();
        const std::array<std::int32_t, 3>& block = states_.blocks()[static_cast<std::size_t>(k)];
        const Cube low{kCubes * block[0], kCubes * block[1], kCubes * block[2]};
        const std::size_t index = states_.lattice().block_index(block);
        whole_[index] = is_plane(low, kCubes) ? 1 : 0;
        for (int i = 0; whole_[index] == 0 && i < 8; ++i) {
            const Cube eighth{low[0] + kHalf * (i & 1), low[1] + kHalf * (i >> 1 & 1), low[2] + kHalf * (i >> 2)};
            const unsigned bit = is_plane(eighth, kHalf) ? 0U : 1U << i;
            single_[index] = static_cast<std::uint8_t>(single_[index] | bit);
        }
    });
    std::vector<char> known(whole_.size(), 0);
    for (const std::array<std::int32_t, 3>& block : states.blocks()) {
        known[states.lattice().block_index(block)] = 1;
        divide_beside(block);
    }
    for (const std::array<std::int32_t, 3>& block : states.blocks()) {
        add_neighbours(block, known);
    }
}

bool GradedCells::contains(const Cube& cube) const {
    for (std::size_t i = 0; i < 3; ++i) {
        if (cube[i] < 0 || cube[i] >= kCubes * states_.lattice().blocks()[i]) {
            return false;
        }
    }
    return true;
}

bool GradedCells::is_plane(const Cube& low, std::int32_t across) const {
    constexpr double kSlack = 1e-3;  // a fraction of a side, between a point and the plane
    const Lattice& lattice = states_.lattice();
    const double slack = kSlack * lattice.side();
    const std::optional<Plane> plane =
        plane_in(states_.surface(), patch_, lattice.at(centre_of(low, across)), across * lattice.side(), slack);
    if (!plane) {
        return false;
    }
    const Node first{2 * low[0], 2 * low[1], 2 * low[2]};
    const auto is_outside = [&](const Node& node) { return !lattice.contains(node) || states_.is_outside(node); };
    bool is_one = true;               // all nodes are on one side
    bool is_above[2] = {true, true};  // [0]: outside nodes are above the plane, inner ones below; [1]: the reverse
    const bool known = all_nodes(first, across, [&](const Node& node) {
        const NodeState* state = lattice.contains(node) ? states_.find(node) : nullptr;
        if (state != nullptr && (state->moved || state->sheet)) {
            return false;
        }
        const bool outside = is_outside(node);
        is_one = is_one && outside == is_outside(first);
        const double height = plane->height(lattice.at(node));
        if (std::abs(height) > slack) {
            is_above[outside == (height > 0.0) ? 1 : 0] = false;
        }
        return is_one || (plane->triangle >= 0 && (is_above[0] || is_above[1]));
    });
    if (!known || is_one) {
        return known;
    }
    return all_nodes(first, across, [&](const Node& node) {
        for (int k = 0; k < 7; ++k) {
            const Node other = node + Lattice::steps()[static_cast<std::size_t>(k)];
            const bool is_in =
                std::equal(other.begin(), other.end(), first.begin(),
                           [&](std::int32_t i, std::int32_t j) { return i >= j && i <= j + 2 * across; });
            if (is_in && is_outside(node) != is_outside(other) &&
                !(lattice.contains(node) && lattice.contains(other) && states_.is_barred(node, k))) {
                return false;
            }
        }
        return true;
    });
}

/// Divides the whole blocks that share a corner with single cubes of a block.
void GradedCells::divide_beside(const std::array<std::int32_t, 3>& block) {
    const unsigned single = single_[states_.lattice().block_index(block)];
    for (int k = 0; k < 8; ++k) {
        if ((single >> k & 1U) == 0) {
            continue;
        }
        for (int way = 0; way < 27; ++way) {
            const Cube near{kCubes * block[0] + kHalf * ((k & 1) + way % 3 - 1),
                            kCubes * block[1] + kHalf * ((k >> 1 & 1) + way / 3 % 3 - 1),
                            kCubes * block[2] + kHalf * ((k >> 2) + way / 9 - 1)};
            if (contains(near)) {
                whole_[block_of(near)] = 0;
            }
        }
    }
}

/// Adds the blocks that share a face with one: smaller cubes may be in them than in it.
void GradedCells::add_neighbours(const std::array<std::int32_t, 3>& block, std::vector<char>& known) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int way : {-1, 1}) {
            std::array<std::int32_t, 3> beside = block;
            beside[axis] += way;
            if (beside[axis] < 0 || beside[axis] >= states_.lattice().blocks()[axis]) {
                continue;
            }
            char& is_known = known[states_.lattice().block_index(beside)];
            if (is_known == 0) {
                is_known = 1;
                blocks_.push_back(beside);
            }
        }
    }
}

}  // namespace mq::wrap

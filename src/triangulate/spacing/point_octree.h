// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "base/vec.h"

namespace mq::triangulate {

/// Finds points near a point among points whose density varies by orders of magnitude: an octree of hashed cells, in
/// which a point lies in a cell about as large as its spacing.
class PointOctree {
  public:
    /// @return the point's number, counted from 0. `spacing` > 0 is about the distance to its neighbours.
    int add(const Vec3& point, double spacing);
    int size() const { return static_cast<int>(points_.size()); }
    const Vec3& point(int i) const { return points_[i]; }

    /// Calls visit(number) for a superset of all points within `radius` of `centre` until it returns true.
    /// @return whether it did. The order is that of the cells, the same on every run.
    template <typename Visit>
    bool any_near(const Vec3& centre, double radius, Visit&& visit) const {
        if (points_.empty()) {
            return false;
        }
        const Reach reach{centre - Vec3::Constant(radius), centre + Vec3::Constant(radius)};
        // On this level and above it the ball meets at most 8 cells, unless it is larger than all of them.
        const int start = std::min(std::max(level_of(2.0 * radius), lowest_), top());
        for (int k = top(); k > start; --k) {
            if (level(k).points > 0 && visit_range(range(reach, k), k, nullptr, visit)) {
                return true;
            }
        }
        return visit_range(range(reach, start), start, &reach, visit);
    }

  private:
    using Cell = std::array<std::int64_t, 3>;
    // The box around a ball.
    struct Reach {
        Vec3 low;
        Vec3 high;
    };
    struct Range {
        Cell low;
        Cell high;

        double cells() const {
            return static_cast<double>(high[0] - low[0] + 1) * static_cast<double>(high[1] - low[1] + 1) *
                   static_cast<double>(high[2] - low[2] + 1);
        }
    };
    // The cells of one size: cells of level k have sides of 2^k.
    struct Level {
        KeyMap<int> first;  // by cell: the first point of its chain
        KeySet parents;     // cells that contain points of lower levels
        int points = 0;
    };

    static int level_of(double size) { return std::ilogb(size) + 1; }
    static std::int64_t floor(double x) {
        const auto towards_zero = static_cast<std::int64_t>(x);
        return towards_zero - (x < static_cast<double>(towards_zero) ? 1 : 0);
    }
    static Cell cell_of(const Vec3& p, int level) {
        const double scale = std::ldexp(1.0, -level);
        return {floor(scale * p.x()), floor(scale * p.y()), floor(scale * p.z())};
    }
    // Distant cells may share a key; their points are then visited needlessly.
    static std::uint64_t key(const Cell& cell) {
        // 21 bits for each coordinate, so that three of them fit into 64 bits.
        constexpr std::uint64_t kMask = (1ULL << 21) - 1;
        return (static_cast<std::uint64_t>(cell[0]) & kMask) << 42 |
               (static_cast<std::uint64_t>(cell[1]) & kMask) << 21 | (static_cast<std::uint64_t>(cell[2]) & kMask);
    }
    static Range range(const Reach& reach, int level) {
        return {cell_of(reach.low, level), cell_of(reach.high, level)};
    }
    int top() const { return lowest_ + static_cast<int>(levels_.size()) - 1; }
    const Level& level(int k) const { return levels_[static_cast<std::size_t>(k - lowest_)]; }
    Level& level(int k) { return levels_[static_cast<std::size_t>(k - lowest_)]; }
    void add_levels(int k);
    void mark_parents(const Vec3& point, int from);

    // With `below` also visits points on lower levels in these cells and in that box.
    template <typename Visit>
    bool visit_range(const Range& r, int k, const Reach* below, Visit& visit) const {
        if (r.cells() > static_cast<double>(size())) {
            return visit_all(k, below != nullptr, visit);
        }
        Cell cell;
        for (cell[0] = r.low[0]; cell[0] <= r.high[0]; ++cell[0]) {
            for (cell[1] = r.low[1]; cell[1] <= r.high[1]; ++cell[1]) {
                for (cell[2] = r.low[2]; cell[2] <= r.high[2]; ++cell[2]) {
                    if (visit_cell(cell, k, below, visit)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    template <typename Visit>
    bool visit_cell(const Cell& cell, int k, const Reach* below, Visit& visit) const {
        const std::uint64_t here = key(cell);
        const auto first = level(k).first.find(here);
        for (int i = first == level(k).first.end() ? -1 : first->second; i >= 0; i = next_[i]) {
            if (visit(i)) {
                return true;
            }
        }
        if (below == nullptr || level(k).parents.count(here) == 0) {
            return false;
        }
        Range inside = range(*below, k - 1);
        for (int axis = 0; axis < 3; ++axis) {
            inside.low[axis] = std::max(inside.low[axis], 2 * cell[axis]);
            inside.high[axis] = std::min(inside.high[axis], 2 * cell[axis] + 1);
        }
        return visit_range(inside, k - 1, below, visit);
    }

    template <typename Visit>
    bool visit_all(int k, bool below, Visit& visit) const {
        for (int i = 0; i < size(); ++i) {
            if ((own_level_[i] == k || (below && own_level_[i] < k)) && visit(i)) {
                return true;
            }
        }
        return false;
    }

    std::vector<Vec3> points_;
    std::vector<int> next_;
    std::vector<std::int16_t> own_level_;  // by point
    std::vector<Level> levels_;
    int lowest_ = 0;  // level of levels_[0]
};

}  // namespace mq::triangulate

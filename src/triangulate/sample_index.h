// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "base/key_set.h"
#include "base/vec.h"

namespace mq::triangulate {

/// Finds points near a point among points whose density varies by orders of magnitude: a hash grid for every power of
/// two of their spacing.
class SampleIndex {
  public:
    /// @return the point's number, counted from 0. `spacing` > 0 is about the distance to its neighbours.
    int add(const Vec3& point, double spacing);
    int size() const { return static_cast<int>(points_.size()); }
    const Vec3& point(int i) const { return points_[i]; }

    /// Calls visit(number) for a superset of all points within `radius` of `centre` until it returns true.
    /// @return whether it did. The order is that of the grid, the same on every run.
    template <typename Visit>
    bool any_near(const Vec3& centre, double radius, Visit&& visit) const {
        for (const auto& [level, grid] : grids_) {
            const double cell = std::ldexp(1.0, level);
            const Cell low = cell_of(centre - Vec3::Constant(radius), cell);
            const Cell high = cell_of(centre + Vec3::Constant(radius), cell);
            const double cells = static_cast<double>(high[0] - low[0] + 1) * static_cast<double>(high[1] - low[1] + 1) *
                                 static_cast<double>(high[2] - low[2] + 1);
            if (cells > static_cast<double>(grid.members.size())) {
                for (const int i : grid.members) {
                    if (visit(i)) {
                        return true;
                    }
                }
                continue;
            }
            for (std::int64_t x = low[0]; x <= high[0]; ++x) {
                for (std::int64_t y = low[1]; y <= high[1]; ++y) {
                    for (std::int64_t z = low[2]; z <= high[2]; ++z) {
                        const auto first = grid.first.find(key({x, y, z}));
                        for (int i = first == grid.first.end() ? -1 : first->second; i >= 0; i = next_[i]) {
                            if (visit(i)) {
                                return true;
                            }
                        }
                    }
                }
            }
        }
        return false;
    }

  private:
    using Cell = std::array<std::int64_t, 3>;
    struct Grid {
        KeyMap<int> first;         // of the chain of points in a cell
        std::vector<int> members;  // all points of the level
    };
    static Cell cell_of(const Vec3& p, double cell);
    // Cells far apart may share a key; their points are then visited in vain.
    static std::uint64_t key(const Cell& cell);

    std::vector<Vec3> points_;
    std::vector<int> next_;
    std::map<int, Grid> grids_;
};

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "base/vec.h"

namespace mq::contour {

/// Triangles by the cells of a uniform grid that they may meet, for a surface that changes.
class TriangleGrid {
  public:
    /// @param side  of a cell, mm
    explicit TriangleGrid(double side) : side_(side) {}

    void add(std::int32_t triangle, const std::array<Vec3, 3>& corners) {
        for_each_cell(corners, [&](std::uint64_t cell) {
            cells_[cell].push_back(triangle);
            return true;
        });
    }
    void remove(std::int32_t triangle, const std::array<Vec3, 3>& corners) {
        for_each_cell(corners, [&](std::uint64_t cell) {
            const auto at = cells_.find(cell);
            std::vector<std::int32_t>& in = at.value();
            *std::find(in.begin(), in.end(), triangle) = in.back();
            in.pop_back();
            return true;
        });
    }
    /// Whether visit(triangle) returns true for all triangles in the cells that a triangle with these corners may meet.
    /// A triangle in several cells may be visited several times.
    template <typename Visit>
    bool all_near(const std::array<Vec3, 3>& corners, const Visit& visit) const {
        return for_each_cell(corners, [&](std::uint64_t cell) {
            const auto at = cells_.find(cell);
            return at == cells_.end() || std::all_of(at->second.begin(), at->second.end(), visit);
        });
    }

  private:
    /// The cells that both the box and the plane of a triangle meet.
    template <typename Visit>
    bool for_each_cell(const std::array<Vec3, 3>& corners, const Visit& visit) const {
        std::array<std::int64_t, 3> low{};
        std::array<std::int64_t, 3> high{};
        for (int i = 0; i < 3; ++i) {
            const auto [least, most] = std::minmax({corners[0][i], corners[1][i], corners[2][i]});
            low[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(least / side_));
            high[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(most / side_));
        }
        const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        // A little more than half of a cell's extent along the normal, for rounding.
        const double reach = 0.501 * side_ * normal.lpNorm<1>();
        for (std::int64_t x = low[0]; x <= high[0]; ++x) {
            for (std::int64_t y = low[1]; y <= high[1]; ++y) {
                for (std::int64_t z = low[2]; z <= high[2]; ++z) {
                    const Vec3 centre = side_ * Vec3(double(x) + 0.5, double(y) + 0.5, double(z) + 0.5);
                    if (std::abs(normal.dot(centre - corners[0])) > reach) {
                        continue;
                    }
                    constexpr std::int64_t kMask = 0x1FFFFF;
                    if (!visit(static_cast<std::uint64_t>((x & kMask) << 42 | (y & kMask) << 21 | (z & kMask)))) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    double side_;
    KeyMap<std::vector<std::int32_t>> cells_;
};

}  // namespace mq::contour

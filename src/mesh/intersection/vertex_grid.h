// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// A uniform grid over a box, with the cell of each vertex of a mesh: which cells the box of a triangle meets is then
/// known without its coordinates.
///
/// The cell of a coordinate is a monotone function of it, however it is rounded. Along each axis the first and the last
/// cell take what is outside of the box.
class VertexGrid {
  public:
    static constexpr int kMostCells =
        126;  ///< cells inside of the box along a side, so that an octet holds a coordinate

    /// @param count  cells inside of the box along each side, 1 to kMostCells
    VertexGrid(const std::vector<Vec3>& vertices, const Box& box, const std::array<int, 3>& count)
        : cell_(vertices.size()), side_{count[0] + 2, count[1] + 2, count[2] + 2} {
        Vec3 scale;
        for (int i = 0; i < 3; ++i) {
            const double side = box.high[i] - box.low[i];
            scale[i] = side > 0.0 ? count[i] / side : 0.0;
        }
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            for (int i = 0; i < 3; ++i) {
                const double x = vertices[v][i];
                const double inside = 1.0 + std::min((x - box.low[i]) * scale[i], count[i] - 1.0);
                cell_[v][i] = static_cast<std::uint8_t>(x < box.low[i]    ? 0.0
                                                        : x > box.high[i] ? count[i] + 1.0
                                                                          : inside);
            }
        }
    }

    std::size_t size() const { return static_cast<std::size_t>(side_[0]) * side_[1] * side_[2]; }

    /// use(cell) for each cell of the box of a triangle. False if the box has more than `most` cells, or as soon as
    /// `use` returns false. A triangle beside the grid's box has no cells.
    template <typename Use>
    bool visit(const Triangle& t, int most, const Use& use) const {
        std::array<int, 3> low;
        std::array<int, 3> high;
        for (int i = 0; i < 3; ++i) {
            const auto [least, greatest] = std::minmax({cell_[t[0]][i], cell_[t[1]][i], cell_[t[2]][i]});
            low[i] = least;
            high[i] = greatest;
            if (greatest == 0 || least == side_[i] - 1) {
                return true;
            }
        }
        return (high[0] - low[0] + 1) * (high[1] - low[1] + 1) * (high[2] - low[2] + 1) <= most &&
               visit(low, high, use);
    }

  private:
    template <typename Use>
    bool visit(const std::array<int, 3>& low, const std::array<int, 3>& high, const Use& use) const {
        for (int z = low[2]; z <= high[2]; ++z) {
            for (int y = low[1]; y <= high[1]; ++y) {
                for (int x = low[0]; x <= high[0]; ++x) {
                    if (!use((static_cast<std::size_t>(z) * side_[1] + y) * side_[0] + x)) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    std::vector<std::array<std::uint8_t, 3>> cell_;  ///< by vertex
    std::array<int, 3> side_;                        ///< cells, with those outside
};

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/layered_depth/samples/layered_depth_image.h"
#include "mesh/intersection/winding_number.h"

namespace mq::boolean {

/// Inside is where the winding number is at least this.
constexpr double kInsideWinding = 0.5;
/// The error of the winding number's expansions, with a margin.
constexpr double kWindingError = 0.003;

/// An octree over the cells of a grid that tells of each block how much the winding number may change in it between
/// triangles, and its value where there are none.
class WindingBlocks {
  public:
    struct Block {
        std::array<int, 3> low{};
        int size = 1;             ///< cells along a side
        std::int32_t child = -1;  ///< the first of eight blocks; -1: a leaf
        bool decided = false;     ///< no triangles: all of it is on one side
        double winding = 0.0;     ///< in the middle, where it is decided
        double change = 0.0;      ///< the largest change between triangles on a way through the block, per cell

        /// How far the number is at most from that in the middle of a decided block.
        double doubt() const { return 0.5 * std::sqrt(3.0) * size * change; }
    };

    /// @param box of the operand: outside of it nothing is inside
    WindingBlocks(const SampleGrid& grid, const mesh::WindingNumber& winding, const Box& box, const Progress* progress);

    /// The leaf that holds a point, in grid coordinates.
    const Block& at(const Vec3& g) const;

  private:
    bool must_split(Block& block) const;

    const SampleGrid& grid_;
    const mesh::WindingNumber& winding_;
    Box box_;
    std::vector<Block> blocks_;
};

}  // namespace mq::boolean

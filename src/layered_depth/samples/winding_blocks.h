// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "layered_depth/samples/layered_depth_image.h"
#include "mesh/intersection/surface_winding.h"

namespace mq::layered_depth {

/// Points whose winding number is at least this are inside.
constexpr double kInsideWinding = 0.5;
/// Bound of the error of the winding number's expansions, with a margin.
constexpr double kWindingError = 0.003;

/// An octree over the cells of a grid. Each block has a bound for the change of the winding number between triangles
/// and, if it contains no triangles, the winding number in its middle.
class WindingBlocks {
  public:
    struct Block {
        std::array<int, 3> low{};
        int size = 1;             ///< cells along a side
        std::int32_t child = -1;  ///< the first of eight blocks; -1: a leaf
        bool decided = false;     ///< no triangles: the whole block is on one side
        double winding = 0.0;     ///< in the middle, if `decided`
        double change = 0.0;      ///< bound of the change per cell, between triangles on a path through the block

        /// Largest difference between the winding number anywhere in a decided block and that in its middle.
        double doubt() const { return 0.5 * std::sqrt(3.0) * size * change; }
    };

    /// @param box of the operand: points outside of it are outside of the operand
    WindingBlocks(const SampleGrid& grid, const mesh::SurfaceWinding& winding, const Box& box,
                  const Progress* progress);

    /// The leaf that contains a point, in grid coordinates.
    const Block& at(const Vec3& g) const;

  private:
    bool must_split(Block& block) const;

    const SampleGrid& grid_;
    const mesh::SurfaceWinding& winding_;
    Box box_;
    std::vector<Block> blocks_;
};

}  // namespace mq::layered_depth

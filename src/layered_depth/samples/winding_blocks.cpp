// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/winding_blocks.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace mq::layered_depth {

namespace {

/// Side, in cells, of the largest blocks with triangles that are not divided.
constexpr int kWithTriangles = 8;
/// Largest change along the side of a block with triangles that is not divided: on its rays the triangles are counted.
constexpr double kCalm = 0.2;
/// Blocks of one parallel task.
constexpr std::size_t kBlocksPerTask = 256;

}  // namespace

WindingBlocks::WindingBlocks(const SampleGrid& grid, const mesh::SurfaceWinding& winding, const Box& box,
                             const Progress* progress)
    : grid_(grid), winding_(winding), box_(box) {
    Block root;
    root.size = grid.cells();
    blocks_.push_back(root);
    for (std::size_t first = 0; first < blocks_.size();) {  // one level after another
        const std::size_t end = blocks_.size();
        std::vector<char> split(end - first, 0);
        const std::size_t tasks = (split.size() + kBlocksPerTask - 1) / kBlocksPerTask;
        parallel_for(static_cast<int>(tasks), [&](int task) {
            check_cancelled(progress);
            const std::size_t from = first + static_cast<std::size_t>(task) * kBlocksPerTask;
            for (std::size_t b = from; b < std::min(end, from + kBlocksPerTask); ++b) {
                split[b - first] = must_split(blocks_[b]) ? 1 : 0;
            }
        });
        for (std::size_t b = first; b < end; ++b) {
            if (split[b - first] == 0) {
                continue;
            }
            blocks_[b].child = static_cast<std::int32_t>(blocks_.size());
            const Block parent = blocks_[b];
            for (int c = 0; c < 8; ++c) {
                Block child;
                child.size = parent.size / 2;
                for (int k = 0; k < 3; ++k) {
                    child.low[k] = parent.low[k] + (c >> k & 1) * child.size;
                }
                blocks_.push_back(child);
            }
        }
        first = end;
    }
}

bool WindingBlocks::must_split(Block& block) const {
    Box box;
    const Vec3 low(block.low[0], block.low[1], block.low[2]);
    box.add(grid_.to_space(low));
    box.add(grid_.to_space(low + Vec3::Constant(block.size)));
    if (!box.meets(box_)) {
        block.decided = true;
        return false;
    }
    block.change = winding_.steepest(box.center(), 0.5 * (box.high - box.low).norm()) * grid_.spacing();
    bool empty = true;
    winding_.tree().for_each_in_box(box, [&](std::int32_t) { return empty = false; });
    if (!empty) {
        return block.size > kWithTriangles || (block.size > 1 && block.change * block.size > kCalm);
    }
    block.winding = winding_.at(box.center());
    block.decided = std::abs(block.winding - kInsideWinding) > block.doubt() + kWindingError;
    return !block.decided && block.size > 1;
}

const WindingBlocks::Block& WindingBlocks::at(const Vec3& g) const {
    const Block* block = &blocks_[0];
    while (block->child >= 0) {
        int c = 0;
        for (int k = 0; k < 3; ++k) {
            c |= g[k] >= block->low[k] + block->size / 2 ? 1 << k : 0;
        }
        block = &blocks_[static_cast<std::size_t>(block->child + c)];
    }
    return *block;
}

}  // namespace mq::layered_depth

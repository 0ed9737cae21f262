// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "triangulate/rounds/mesh_blocks.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Insertions in a block, at least, from which on cutting a mesh into blocks pays: about 5 ms of work. In smaller
/// blocks more of them lie beside cuts, and are made out of order.
constexpr std::size_t kInsertionsInBlock = 1024;
/// Insertions from which on blocks pay.
constexpr std::size_t kInsertionsInRound = 4 * kInsertionsInBlock;

/// Returns the number of blocks for that number of insertions; 1: blocks do not pay, or indices of triangles are
/// unused.
inline std::size_t blocks_for(const Workspace& work, std::size_t insertions) {
    constexpr std::size_t kMostBlocks = 4096;
    constexpr std::size_t kLeastShare = 32;  // one insertion for that number of triangles: all are cut into blocks
    const bool unused = work.mesh.used_triangle_count() < work.mesh.triangle_count();
    return unused || insertions < kInsertionsInRound || insertions * kLeastShare < work.triangles()
               ? 1
               : std::min(kMostBlocks, insertions / kInsertionsInBlock);
}

/// Calls `edit(answerer, workspace, k)` for every block, each on one of several threads: it changes triangles of block
/// k, and inserts at most `insertions[k]` vertices inside faces. Its workspace is the block's own but for the mesh, and
/// nobody limits its triangles. Then the blocks are joined, and the edges between them are swapped where that enlarges
/// angles.
/// @throws Cancelled, and what `edit` throws
template <typename Edit>
void edit_in_blocks(Workspace& work, MeshBlocks& blocks, const std::vector<std::size_t>& insertions, const Edit& edit) {
    constexpr std::size_t kBlocksOfThread = 4;  // between which the engine is open to others
    std::vector<std::unique_ptr<MaxMinSwaps>> swaps;
    for (std::size_t k = 0; k < blocks.count(); ++k) {
        swaps.push_back(std::make_unique<MaxMinSwaps>(work.mesh, work.maxmin));
    }
    blocks.reserve(insertions);
    const std::size_t piece = kBlocksOfThread * static_cast<std::size_t>(thread_count());
    for (std::size_t from = 0; from < blocks.count(); from += piece) {
        const std::size_t count = std::min(piece, blocks.count() - from);
        work.session.run_parallel(static_cast<int>(count), [&](geometry::Answerer& answerer, int i) {
            const std::size_t k = from + static_cast<std::size_t>(i);
            const ClassifiedMesh::SharedEditing editing(blocks.share(k));
            Workspace block{work.session, work.grid, work.mesh, *swaps[k], work.progress, work.floor, work.min_edge};
            edit(answerer, block, k);
        });
    }
    std::vector<int> cuts = blocks.join();
    for (std::size_t k = 0; k < blocks.count(); ++k) {
        work.maxmin.adopt(*swaps[k], [&](int vertex) { return blocks.joined_vertex(k, vertex); });
    }
    std::vector<int> touched;
    work.maxmin.restore(cuts, touched);
}

}  // namespace mq::triangulate

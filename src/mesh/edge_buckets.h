// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/parallel.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// A corner in the bucket of the lower vertex of its edge.
struct EdgeEntry {
    std::int32_t high;             ///< the edge's other vertex
    std::uint32_t corner_and_way;  ///< 2 * corner, plus 1 when the edge runs from the lower vertex

    std::uint32_t corner() const { return corner_and_way >> 1; }
    bool upward() const { return (corner_and_way & 1u) != 0; }
    bool operator<(const EdgeEntry& o) const {
        return high != o.high ? high < o.high : corner_and_way < o.corner_and_way;
    }
};

/// The corners (directed edges, 3 * triangle + i) of a triangle soup in buckets by the lower vertex of their edges,
/// each sorted by the higher one, then by the corner. Triangles that name a vertex twice are left out.
struct EdgeBuckets {
    LargeVector<std::uint32_t> begin;  ///< by vertex: its first entry; at the end the number of entries
    LargeVector<EdgeEntry> entries;
};

inline void sort_bucket(EdgeEntry* first, EdgeEntry* last) {
    // Largest bucket for which insertion sort is faster than std::sort.
    constexpr std::ptrdiff_t kSmall = 24;
    if (last - first > kSmall) {
        std::sort(first, last);
        return;
    }
    for (EdgeEntry* i = first; i < last; ++i) {
        const EdgeEntry entry = *i;
        EdgeEntry* j = i;
        for (; j > first && entry < j[-1]; --j) {
            *j = j[-1];
        }
        *j = entry;
    }
}

/// Makes the buckets, and calls visit(first, last) for the entries of each vertex, for blocks of vertices in parallel.
/// O(n), 60 to 140 ns a triangle on one thread; each block reads all triangles, and keeps the edges whose lower vertex
/// is its own. Every vertex index must be in range.
template <typename Visit>
EdgeBuckets edge_buckets(const std::vector<Triangle>& triangles, std::size_t vertex_count, const Visit& visit) {
    // Number of triangles per thread above which starting the thread pays.
    constexpr std::size_t kWorthAThread = 32768;
    // With more blocks, reading all triangles for each of them takes longer than the rest of the work.
    constexpr int kMostBlocks = 8;
    const auto blocks = static_cast<std::size_t>(std::min(threads_for(triangles.size(), kWorthAThread), kMostBlocks));
    const auto in_blocks = [&](const auto& work) {
        parallel_for(static_cast<int>(blocks), [&](int k) {
            const auto block = static_cast<std::size_t>(k);
            work(static_cast<std::int32_t>(vertex_count * block / blocks),
                 static_cast<std::int32_t>(vertex_count * (block + 1) / blocks));
        });
    };
    const auto for_each_edge = [&](std::int32_t first, std::int32_t last, const auto& use) {
        for (std::size_t k = 0; k < triangles.size(); ++k) {
            const Triangle& t = triangles[k];
            for (std::size_t i = 0; i < 3 && !is_collapsed(t); ++i) {
                const std::int32_t low = std::min(t[i], t[(i + 1) % 3]);
                if (low >= first && low < last) {
                    use(static_cast<std::size_t>(low),
                        EdgeEntry{std::max(t[i], t[(i + 1) % 3]),
                                  static_cast<std::uint32_t>(2 * (3 * k + i) + (t[i] == low ? 1 : 0))});
                }
            }
        }
    };
    EdgeBuckets buckets;
    LargeVector<std::uint32_t>& begin = buckets.begin;
    begin.assign(vertex_count + 2, 0);
    in_blocks([&](std::int32_t first, std::int32_t last) {
        for_each_edge(first, last, [&](std::size_t low, const EdgeEntry&) { ++begin[low + 2]; });
    });
    for (std::size_t v = 2; v < begin.size(); ++v) {
        begin[v] += begin[v - 1];
    }
    buckets.entries.resize(begin.back());
    // begin[v + 1] is the next free entry of v's bucket, and finally the bucket's end.
    in_blocks([&](std::int32_t first, std::int32_t last) {
        for_each_edge(first, last,
                      [&](std::size_t low, const EdgeEntry& entry) { buckets.entries[begin[low + 1]++] = entry; });
    });
    begin.pop_back();
    in_blocks([&](std::int32_t first, std::int32_t last) {
        for (auto v = static_cast<std::size_t>(first); v < static_cast<std::size_t>(last); ++v) {
            EdgeEntry* const here = buckets.entries.data() + begin[v];
            EdgeEntry* const end = buckets.entries.data() + begin[v + 1];
            sort_bucket(here, end);
            visit(here, end);
        }
    });
    return buckets;
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/edge_buckets.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// All edges of a triangle soup, each with the corners of the triangles that have it.
///
/// A corner is 3 * triangle + i and stands for the directed edge from the triangle's vertex i to its vertex i + 1.
/// Triangles that name a vertex twice have no sides and are left out. Time O(n) for vertices of bounded degree.
class EdgeTable {
  public:
    /// Every vertex index must be in range.
    EdgeTable(const std::vector<Triangle>& triangles, std::size_t vertex_count);

    /// Calls visit(low, high, first, last) once for each undirected edge low < high, in ascending order; [first, last)
    /// are its corners in ascending order.
    template <typename Visit>
    void for_each(Visit&& visit) const {
        std::vector<std::uint32_t> corners;
        for (std::size_t low = 0; low + 1 < buckets_.begin.size(); ++low) {
            const EdgeEntry* const last = buckets_.entries.data() + buckets_.begin[low + 1];
            for (const EdgeEntry* i = buckets_.entries.data() + buckets_.begin[low]; i != last;) {
                const std::int32_t high = i->high;
                corners.clear();
                for (; i != last && i->high == high; ++i) {
                    corners.push_back(i->corner());
                }
                visit(static_cast<std::int32_t>(low), high, corners.data(), corners.data() + corners.size());
            }
        }
    }

  private:
    EdgeBuckets buckets_;
};

/// Throws InvalidInput unless every index is in range, every coordinate a number, and the optional arrays are either
/// empty or of full length.
void require_valid(const TriangleMesh& mesh);

}  // namespace mq::mesh

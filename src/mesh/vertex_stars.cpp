// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/vertex_stars.h"

namespace mq::mesh {

VertexStars::VertexStars(const std::vector<Triangle>& triangles, std::size_t vertex_count)
    : begin_(vertex_count + 1, 0), corners_(3 * triangles.size()) {
    for (const Triangle& t : triangles) {
        for (const std::int32_t v : t) {
            ++begin_[v];
        }
    }
    // begin_[v] is first the star's end, and counts down to its beginning.
    std::uint32_t sum = 0;
    for (std::uint32_t& entry : begin_) {
        sum += entry;
        entry = sum;
    }
    for (std::size_t k = triangles.size(); k-- > 0;) {
        for (int i = 2; i >= 0; --i) {
            corners_[--begin_[triangles[k][i]]] = static_cast<std::uint32_t>(3 * k + i);
        }
    }
}

}  // namespace mq::mesh

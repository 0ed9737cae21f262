// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// The corners at each vertex of a triangle soup, in ascending order.
///
/// A corner is 3 * triangle + i, as in EdgeTable, and stands for the triangle's vertex i or the directed edge that
/// leaves it. O(n), 20 ns a triangle.
class VertexStars {
  public:
    /// Every vertex index must be in range.
    VertexStars(const std::vector<Triangle>& triangles, std::size_t vertex_count);

    struct Star {
        const std::uint32_t* first;
        const std::uint32_t* last;

        const std::uint32_t* begin() const { return first; }
        const std::uint32_t* end() const { return last; }
        std::size_t size() const { return last - first; }
    };
    Star operator[](std::size_t vertex) const {
        return {corners_.data() + begin_[vertex], corners_.data() + begin_[vertex + 1]};
    }
    std::size_t size() const { return begin_.size() - 1; }

  private:
    std::vector<std::uint32_t> begin_;
    std::vector<std::uint32_t> corners_;
};

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/surface_mesh.h"

namespace mq::triangulate {

/// Marks on edges, each named by a half-edge, that last as long as the edge.
class EdgeMarks {
  public:
    bool marked(const mesh::SurfaceMesh& mesh, int half_edge) const {
        const auto number = static_cast<std::size_t>(mesh.number_of(half_edge));
        return number < marks_.size() && marks_[number] != 0;
    }
    void mark(const mesh::SurfaceMesh& mesh, int half_edge) {
        const auto number = static_cast<std::size_t>(mesh.number_of(half_edge));
        if (number >= marks_.size()) {
            marks_.resize(static_cast<std::size_t>(mesh.number_count()), 0);
        }
        marks_[number] = 1;
    }

  private:
    std::vector<char> marks_;  // by the edge's number
};

}  // namespace mq::triangulate

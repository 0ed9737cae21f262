// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "mesh/surface_mesh.h"

namespace mq::triangulate {

/// Marks on triangles that last until the triangle changes: what was found out about it as it is.
class TriangleMarks {
  public:
    bool marked(const mesh::SurfaceMesh& mesh, int triangle) const {
        const auto t = static_cast<std::size_t>(triangle);
        return t < marks_.size() && marks_[t] == mesh.stamp(triangle) + 1;
    }
    void mark(const mesh::SurfaceMesh& mesh, int triangle) {
        const auto t = static_cast<std::size_t>(triangle);
        if (t >= marks_.size()) {
            marks_.resize(static_cast<std::size_t>(mesh.triangle_count()), 0);
        }
        marks_[t] = mesh.stamp(triangle) + 1;
    }
    void unmark(int triangle) {
        const auto t = static_cast<std::size_t>(triangle);
        if (t < marks_.size()) {
            marks_[t] = 0;
        }
    }
    void clear() { marks_.clear(); }

  private:
    std::vector<std::uint32_t> marks_;  // by triangle: 1 + its stamp when it was marked; 0: never
};

/// Of these triangles as they are now: another one when any of them changes.
inline std::uint64_t state_key(const mesh::SurfaceMesh& mesh, const std::vector<int>& triangles) {
    std::uint64_t sum = triangles.size();
    for (const int t : triangles) {
        sum = KeyHash()(sum ^ ordered_key(static_cast<std::uint32_t>(t), mesh.stamp(t))) + sum;
    }
    return sum;
}

}  // namespace mq::triangulate

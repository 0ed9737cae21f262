// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Marks on triangles that hold until the triangle changes.
class TriangleMarks {
  public:
    /// Makes room for the marks of all triangles, so that several threads may mark different ones.
    void cover(const ClassifiedMesh& mesh) {
        marks_.resize(std::max(marks_.size(), static_cast<std::size_t>(mesh.triangle_count())), 0);
    }
    bool marked(const ClassifiedMesh& mesh, int triangle) const {
        const auto t = static_cast<std::size_t>(triangle);
        return t < marks_.size() && marks_[t] == mesh.stamp(triangle) + 1;
    }
    void mark(const ClassifiedMesh& mesh, int triangle) {
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
    /// Follows ClassifiedMesh::order_in_space.
    void renumber(const NewIndices& renewed) { move_to_indices(renewed.triangles, marks_, 0); }

  private:
    LargeVector<std::uint32_t> marks_;  // by triangle: 1 + its version when it was marked; 0: never
};

/// Marks on edges, each named by a half-edge, that last as long as the edge.
class EdgeMarks {
  public:
    bool marked(const ClassifiedMesh& mesh, int half_edge) const {
        const auto number = static_cast<std::size_t>(mesh.number_of(half_edge));
        return number < marks_.size() && marks_[number] != 0;
    }
    void mark(const ClassifiedMesh& mesh, int half_edge) {
        const auto number = static_cast<std::size_t>(mesh.number_of(half_edge));
        if (number >= marks_.size()) {
            marks_.resize(static_cast<std::size_t>(mesh.number_count()), 0);
        }
        marks_[number] = 1;
    }
    /// Follows ClassifiedMesh::renumber_edges.
    void renumber(const LargeVector<int>& renewed) { move_to_numbers(renewed, marks_); }
    /// Follows ClassifiedMesh::order_in_space.
    void renumber(const NewIndices& renewed) { move_to_indices(renewed.edges, marks_, 0); }

  private:
    LargeVector<char> marks_;  // by the edge's number
};

/// Returns a key of these triangles in their present state, which differs once any of them changes.
inline std::uint64_t state_key(const ClassifiedMesh& mesh, const std::vector<int>& triangles) {
    std::uint64_t sum = triangles.size();
    for (const int t : triangles) {
        sum = KeyHash()(sum ^ ordered_key(static_cast<std::uint32_t>(t), mesh.stamp(t))) + sum;
    }
    return sum;
}

}  // namespace mq::triangulate

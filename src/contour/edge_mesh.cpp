// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/edge_mesh.h"

#include <algorithm>
#include <utility>

namespace mq::contour {

using mesh::Triangle;

EdgeMesh::EdgeMesh(std::vector<Triangle>& triangles, std::size_t vertices)
    : triangles_(triangles), corners_(triangles, vertices), edges_of_(triangles.size()), marks_(vertices) {
    ends_.reserve(triangles.size() * 3 / 2);
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(triangles.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            add_edge(t, k);
        }
    }
}

/// Numbers the edge after a corner, unless it has its number from the triangle beyond it.
void EdgeMesh::add_edge(std::int32_t t, int k) {
    const std::int32_t a = triangles_[t][k];
    const std::int32_t b = triangles_[t][(k + 1) % 3];
    const std::int32_t beyond = corner_of(b, a);
    if (beyond >= 0 && beyond / 3 < t) {
        edges_of_[t][k] = edge_after(beyond / 3, beyond % 3);
        return;
    }
    edges_of_[t][k] = static_cast<std::int32_t>(ends_.size());
    ends_.push_back({a, b});
}

std::int32_t EdgeMesh::corner_of(std::int32_t a, std::int32_t b) const {
    for (const std::int32_t corner : corners_.at(a)) {
        if (triangles_[corner / 3][(corner % 3 + 1) % 3] == b) {
            return corner;
        }
    }
    return -1;
}

bool EdgeMesh::keeps_links(std::int32_t a, std::int32_t b) {
    constexpr std::size_t kOfTetrahedron = 6;  // triangles at both ends
    const std::uint32_t joined = next_mark_;
    const std::uint32_t beside = next_mark_ + 1;
    next_mark_ += 2;
    std::size_t count = 0;
    for (const std::int32_t corner : corners_.at(a)) {
        const Triangle& c = triangles_[corner / 3];
        const bool vanishes = has(c, b);
        ++count;
        for (const std::int32_t v : c) {
            if (vanishes && v != a && v != b && std::exchange(marks_[v], beside) == beside) {
                return false;  // two triangles with the same vertices
            }
            marks_[v] = std::max(marks_[v], joined);
        }
    }
    for (const std::int32_t corner : corners_.at(b)) {
        ++count;
        for (const std::int32_t v : triangles_[corner / 3]) {
            if (v != a && v != b && marks_[v] == joined) {
                return false;
            }
        }
    }
    return count > kOfTetrahedron;
}

const EdgeMesh::Merged& EdgeMesh::merge(std::int32_t a, std::int32_t b) {
    merged_.edges.clear();
    merged_.vertices.clear();
    gone_.clear();
    for (const std::int32_t corner : corners_.at(b)) {
        if (has(triangles_[corner / 3], a)) {
            gone_.push_back(corner);
        }
    }
    for (const std::int32_t corner : gone_) {
        remove_triangle(corner, a);
    }
    for (const std::int32_t corner : corners_.at(b)) {
        const std::int32_t t = corner / 3;
        triangles_[t][corner % 3] = a;
        for (const int k : {corner % 3, (corner + 2) % 3}) {
            std::array<std::int32_t, 2>& ends = ends_[edges_of_[t][k]];
            std::replace(ends.begin(), ends.end(), b, a);
        }
    }
    corners_.append(a, b);
    return merged_;
}

/// Removes a triangle of an edge that collapses into a. Its other two edges become one.
/// @param corner  at the other end
void EdgeMesh::remove_triangle(std::int32_t corner, std::int32_t a) {
    const std::int32_t t = corner / 3;
    const int k = corner % 3;
    const Triangle c = triangles_[t];
    const bool runs_to_a = c[(k + 1) % 3] == a;
    const int at_a = runs_to_a ? (k + 1) % 3 : (k + 2) % 3;
    const int beside = 3 - k - at_a;
    const std::int32_t stays = edge_after(t, runs_to_a ? at_a : beside);
    const std::int32_t goes = edge_after(t, runs_to_a ? beside : k);
    const std::int32_t beyond = runs_to_a ? corner_of(c[k], c[beside]) : corner_of(c[beside], c[k]);
    if (beyond >= 0) {
        edges_of_[beyond / 3][beyond % 3] = stays;
    }
    for (const int i : {k, at_a, beside}) {
        corners_.remove(3 * t + i, c[i]);
    }
    triangles_[t] = {-1, -1, -1};
    merged_.edges.push_back(goes);
    merged_.vertices.push_back(c[beside]);
}

}  // namespace mq::contour

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/key_set.h"

namespace mq::tetrahedralise {

/// The edges and triangles that a tetrahedralisation must have: those of a closed surface, and of its subdivision by
/// points that are put on it for a while.
class SurfaceConstraints {
  public:
    using Triangle = std::array<int, 3>;

    /// A point on the surface: the triangles that it has divided, and those that came of them.
    struct Division {
        int vertex;
        std::vector<Triangle> parents;
        std::vector<Triangle> children;
    };

    /// @throws MeshingFailed if an edge has an odd number of triangles; an edge where shells meet may have more than
    /// two.
    explicit SurfaceConstraints(const std::vector<Triangle>& triangles);

    bool has_edge(int a, int b) const { return edges_.count(pair_key(a, b)) > 0; }
    bool has_triangle(int a, int b, int c) const { return faces_.count(key(a, b, c)) > 0; }
    std::vector<std::array<int, 2>> edges() const;
    std::vector<Triangle> triangles() const;

    /// Divides the two triangles at an edge by a vertex on it.
    void divide_edge(int a, int b, int vertex);
    void divide_triangle(const Triangle& triangle, int vertex);
    /// In the order in which they were made.
    const std::vector<Division>& divisions() const { return divisions_; }

  private:
    static Triangle key(int a, int b, int c);
    void add(const Triangle& triangle);
    void remove(const Triangle& triangle);
    void divide(Division division);

    KeyMap<std::vector<Triangle>> edges_;
    tsl::robin_map<Triangle, Triangle, KeyHash> faces_;
    std::vector<Division> divisions_;
};

}  // namespace mq::tetrahedralise

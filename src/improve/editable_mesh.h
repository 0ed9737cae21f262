// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/simplex_stars.h"
#include "mesh/triangle_mesh.h"

namespace mq::improve {

using mesh::Triangle;

/// A change: triangles that are replaced by others. Vertices named in `added` exist already.
struct LocalOperation {
    std::vector<int> removed;
    std::vector<Triangle> added;
    std::vector<std::pair<int, int>> sharp;      ///< edges that become sharp
    std::vector<std::pair<int, int>> not_sharp;  ///< edges that are removed, or sharp no longer
};

/// A triangle mesh that is edited locally. Triangles and vertices keep their index; those that are removed are marked.
/// Sharp edges are those that must stay.
class EditableMesh {
  public:
    /// @param feature_angle radians: edges with a larger angle between their triangles' normals are sharp, as are edges
    /// of one or of more than two triangles. Triangles too thin to have a normal do not make edges sharp.
    EditableMesh(const mesh::TriangleMesh& given, double feature_angle);

    int triangle_count() const { return static_cast<int>(triangles_.size()); }
    int vertex_count() const { return static_cast<int>(points_.size()); }
    int alive_count() const { return alive_; }
    const Triangle& triangle(int t) const { return triangles_[t]; }
    const Vec3& point(int v) const { return points_[v]; }
    std::array<Vec3, 3> corners(const Triangle& t) const { return {points_[t[0]], points_[t[1]], points_[t[2]]}; }
    bool gone(int t) const { return gone_[t]; }
    /// The triangles at a vertex, in ascending order.
    const std::vector<int>& star(int v) const { return stars_[v]; }

    bool is_sharp(int a, int b) const { return std::binary_search(sharp_at_[a].begin(), sharp_at_[a].end(), b); }
    /// The other ends of the sharp edges at a vertex, in ascending order.
    const std::vector<int>& sharp_neighbours(int v) const { return sharp_at_[v]; }
    /// The triangles with the edge a-b, in ascending order.
    std::vector<int> around_edge(int a, int b) const { return stars_.of({a, b}, triangles_); }
    /// All vertices joined to one, in ascending order.
    std::vector<int> neighbours(int v) const { return stars_.link({v}, triangles_); }
    /// Whether an edge may be collapsed, by the connections alone.
    bool link_condition(int a, int b) const { return stars_.link_condition(a, b, triangles_); }

    int add_vertex(const Vec3& point);
    /// Removes the last vertex, which no triangle uses yet.
    void forget_last_vertex();
    void apply(const LocalOperation& change);

    /// A saved state. Triangles and vertices are only ever added and marked, so that the marks are all that is saved.
    struct State {
        std::vector<char> gone;
        std::vector<std::vector<int>> sharp_at;
        int alive = 0;
    };
    State state() const { return {gone_, sharp_at_, alive_}; }
    /// Restores an earlier state of this mesh.
    void restore(State state);

    /// The present mesh, without vertices that no triangle uses.
    mesh::TriangleMesh result() const;

  private:
    void find_stars();
    void set_sharp(int a, int b, bool sharp);

    std::vector<Vec3> points_;
    std::vector<Triangle> triangles_;
    std::vector<char> gone_;
    mesh::SimplexStars stars_;
    std::vector<std::vector<int>> sharp_at_;
    int alive_ = 0;
};

/// The corner of a triangle that is neither a nor b.
int opposite(const Triangle& t, int a, int b);

}  // namespace mq::improve

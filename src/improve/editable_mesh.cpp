// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/editable_mesh.h"

#include <algorithm>

#include "base/angle.h"
#include "base/tuning.h"
#include "improve/tuning.h"
#include "mesh/edge_table.h"
#include "mesh/quality/triangle_quality.h"

namespace mq::improve {

namespace {

/// The normals of all triangles. A thin triangle gets the normal of its neighbour at its longest edge.
std::vector<Vec3> sound_normals(const EditableMesh& mesh, const mesh::EdgeTable& edges) {
    std::vector<Vec3> normals;
    std::vector<int> next;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        normals.push_back(mesh::robust_normal(mesh.corners(mesh.triangle(t))));
        next.push_back(t);
    }
    edges.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
        const double length = (mesh.point(high) - mesh.point(low)).norm();
        for (const std::uint32_t* c = first; last - first == 2 && c != last; ++c) {
            const auto t = static_cast<int>(*c / 3);
            const Vec3& third = mesh.point(opposite(mesh.triangle(t), low, high));
            const bool longest =
                length >= (third - mesh.point(low)).norm() && length >= (third - mesh.point(high)).norm();
            if (longest && normals[t] == Vec3::Zero()) {
                next[t] = static_cast<int>((c == first ? first[1] : first[0]) / 3);
            }
        }
    });
    std::vector<Vec3> result;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        int at = t;
        for (int steps = 0; normals[at] == Vec3::Zero() && steps < kMostSteps; ++steps) {
            at = next[at];
        }
        result.push_back(normals[at]);
    }
    return result;
}

}  // namespace

EditableMesh::EditableMesh(const mesh::TriangleMesh& given, double feature_angle)
    : points_(given.vertices),
      triangles_(given.triangles),
      gone_(given.triangles.size(), 0),
      sharp_at_(given.vertices.size()),
      alive_(static_cast<int>(given.triangles.size())) {
    find_stars();
    const mesh::EdgeTable edges(triangles_, points_.size());
    const std::vector<Vec3> normals = sound_normals(*this, edges);
    edges.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
        if (last - first != 2 || angle_between(normals[first[0] / 3], normals[first[1] / 3]) > feature_angle) {
            set_sharp(low, high, true);
        }
    });
}

int EditableMesh::add_vertex(const Vec3& point) {
    points_.push_back(point);
    stars_.resize(points_.size());
    sharp_at_.emplace_back();
    return vertex_count() - 1;
}

void EditableMesh::forget_last_vertex() {
    points_.pop_back();
    stars_.resize(points_.size());
    sharp_at_.pop_back();
}

void EditableMesh::apply(const LocalOperation& change) {
    for (const int t : change.removed) {
        gone_[t] = 1;
        stars_.remove(t, triangles_[t]);
    }
    for (const Triangle& c : change.added) {
        stars_.add(triangle_count(), c);
        triangles_.push_back(c);
        gone_.push_back(0);
    }
    for (const auto& [a, b] : change.not_sharp) {
        set_sharp(a, b, false);
    }
    for (const auto& [a, b] : change.sharp) {
        set_sharp(a, b, true);
    }
    alive_ += static_cast<int>(change.added.size()) - static_cast<int>(change.removed.size());
}

void EditableMesh::restore(State state) {
    gone_ = std::move(state.gone);
    sharp_at_ = std::move(state.sharp_at);
    alive_ = state.alive;
    triangles_.resize(gone_.size());
    points_.resize(sharp_at_.size());
    find_stars();
}

void EditableMesh::find_stars() {
    stars_ = mesh::SimplexStars(points_.size());
    for (int t = 0; t < triangle_count(); ++t) {
        if (!gone_[t]) {
            stars_.add(t, triangles_[t]);
        }
    }
}

mesh::TriangleMesh EditableMesh::result() const {
    mesh::TriangleMesh mesh;
    std::vector<std::int32_t> index(points_.size(), -1);
    for (std::size_t v = 0; v < points_.size(); ++v) {
        if (!star(static_cast<int>(v)).empty()) {
            index[v] = static_cast<std::int32_t>(mesh.vertices.size());
            mesh.vertices.push_back(points_[v]);
        }
    }
    for (int t = 0; t < triangle_count(); ++t) {
        if (!gone_[t]) {
            const Triangle& c = triangles_[t];
            mesh.triangles.push_back({index[c[0]], index[c[1]], index[c[2]]});
        }
    }
    return mesh;
}

void EditableMesh::set_sharp(int a, int b, bool sharp) {
    if (sharp == is_sharp(a, b)) {
        return;
    }
    for (const auto& [v, w] : {std::pair(a, b), std::pair(b, a)}) {
        std::vector<int>& list = sharp_at_[v];
        const auto place = std::lower_bound(list.begin(), list.end(), w);
        if (sharp) {
            list.insert(place, w);
        } else {
            list.erase(place);
        }
    }
}

int opposite(const Triangle& t, int a, int b) {
    return *std::find_if(t.begin(), t.end(), [&](int v) { return v != a && v != b; });
}

}  // namespace mq::improve

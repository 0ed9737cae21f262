// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/local_operations.h"

#include <algorithm>

#include "base/angle.h"

namespace mq::improve {

namespace {

bool runs(const Triangle& t, int a, int b) {
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

Triangle with(Triangle t, int v, int other) {
    std::replace(t.begin(), t.end(), v, other);
    return t;
}

bool contains(const Triangle& t, int v) {
    return std::find(t.begin(), t.end(), v) != t.end();
}

}  // namespace

std::optional<LocalOperation> swap_edge(const EditableMesh& mesh, int a, int b) {
    const std::vector<int> sides = mesh.around_edge(a, b);
    if (sides.size() != 2 || mesh.is_sharp(a, b)) {
        return std::nullopt;
    }
    const bool first_runs = runs(mesh.triangle(sides[0]), a, b);
    if (first_runs == runs(mesh.triangle(sides[1]), a, b)) {
        return std::nullopt;
    }
    const int c = opposite(mesh.triangle(sides[first_runs ? 0 : 1]), a, b);
    const int d = opposite(mesh.triangle(sides[first_runs ? 1 : 0]), a, b);
    if (c == d || !mesh.around_edge(c, d).empty()) {
        return std::nullopt;
    }
    return LocalOperation{sides, {{a, d, c}, {d, b, c}}, {}, {}};
}

std::optional<LocalOperation> collapse_edge(const EditableMesh& mesh, int from, int to, double bend) {
    const Freedom free = freedom(mesh, from, bend);
    if (free == Freedom::None || (free == Freedom::Curve && !mesh.is_sharp(from, to))) {
        return std::nullopt;
    }
    if (!mesh.link_condition(from, to)) {
        return std::nullopt;
    }
    LocalOperation change;
    change.removed = mesh.star(from);
    for (const int t : change.removed) {
        if (!contains(mesh.triangle(t), to)) {
            change.added.push_back(with(mesh.triangle(t), from, to));
        }
    }
    // No two triangles that differ in the ends of the edge alone, as two faces of a tetrahedron do, may coincide
    // afterwards.
    const auto is_there = [&](const mesh::Triangle& t) {
        const std::vector<int>& around = mesh.star(to);
        return std::any_of(around.begin(), around.end(), [&](int other_triangle) {
            const mesh::Triangle& there = mesh.triangle(other_triangle);
            return std::is_permutation(t.begin(), t.end(), there.begin());
        });
    };
    if (change.added.empty() || std::any_of(change.added.begin(), change.added.end(), is_there)) {
        return std::nullopt;
    }
    for (const int w : mesh.sharp_neighbours(from)) {
        change.not_sharp.emplace_back(from, w);
        if (w != to) {
            change.sharp.emplace_back(to, w);
        }
    }
    return change;
}

LocalOperation split_edge(const EditableMesh& mesh, int a, int b, int middle) {
    LocalOperation change;
    change.removed = mesh.around_edge(a, b);
    for (const int t : change.removed) {
        change.added.push_back(with(mesh.triangle(t), b, middle));
        change.added.push_back(with(mesh.triangle(t), a, middle));
    }
    if (mesh.is_sharp(a, b)) {
        change.not_sharp = {{a, b}};
        change.sharp = {{a, middle}, {middle, b}};
    }
    return change;
}

LocalOperation replace_vertex(const EditableMesh& mesh, int v, int other) {
    LocalOperation change;
    change.removed = mesh.star(v);
    for (const int t : change.removed) {
        change.added.push_back(with(mesh.triangle(t), v, other));
    }
    for (const int w : mesh.sharp_neighbours(v)) {
        change.not_sharp.emplace_back(v, w);
        change.sharp.emplace_back(other, w);
    }
    return change;
}

Freedom freedom(const EditableMesh& mesh, int v, double bend) {
    const std::vector<int>& sharp = mesh.sharp_neighbours(v);
    if (sharp.empty()) {
        return Freedom::Surface;
    }
    if (sharp.size() != 2) {
        return Freedom::None;
    }
    const Vec3 in = mesh.point(v) - mesh.point(sharp[0]);
    const Vec3 out = mesh.point(sharp[1]) - mesh.point(v);
    return angle_between(in, out) <= bend ? Freedom::Curve : Freedom::None;
}

}  // namespace mq::improve

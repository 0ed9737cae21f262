// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/boundary_recovery.h"

#include <algorithm>
#include <utility>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "tetrahedralise/cells/delaunay.h"
#include "tetrahedralise/cells/tetrahedra.h"
#include "tetrahedralise/star_cavity.h"

namespace mq::tetrahedralise {

namespace {

/// Flips along one edge or triangle at most.
constexpr int kMostFlips = 60;
/// Most removals of other edges for the removal of one edge.
constexpr int kMostCalls = 60;
/// Largest nesting of such removals, in successive attempts.
constexpr std::array<int, 3> kDepths{0, 1, 2};
/// Most points on the surface: the number of its vertices plus twice this.
constexpr std::size_t kMostDivisions = 100;

}  // namespace

RecoveryCount BoundaryRecovery::run() {
    Edges edges = missing_edges();
    count_.missing_edges = edges.size();
    recover_edges(std::move(edges));
    Triangles triangles = missing_triangles();
    count_.missing_triangles = triangles.size();
    while (!triangles.empty()) {
        recover_triangles(std::move(triangles));
        recover_edges(missing_edges());
        triangles = missing_triangles();
    }
    return count_;
}

BoundaryRecovery::Edges BoundaryRecovery::missing_edges() {
    Edges missing;
    for (const auto& e : surface_.edges()) {
        progress_.check();
        if (mesh_.cell_with(e[0], e[1]) < 0) {
            missing.push_back(e);
        }
    }
    return missing;
}

BoundaryRecovery::Triangles BoundaryRecovery::missing_triangles() {
    Triangles missing;
    for (const auto& t : surface_.triangles()) {
        progress_.check();
        if (mesh_.cell_with(t[0], t[1], t[2]) < 0) {
            missing.push_back(t);
        }
    }
    return missing;
}

void BoundaryRecovery::recover_edges(Edges missing) {
    while (!missing.empty()) {
        for (const int depth : kDepths) {
            Edges left;
            for (const auto& e : missing) {
                progress_.check();
                if (!recover_edge(e[0], e[1], depth)) {
                    left.push_back(e);
                }
            }
            missing = std::move(left);
        }
        for (const auto& e : missing) {
            // A point inserted nearby may have restored the edge.
            if (mesh_.cell_with(e[0], e[1]) < 0) {
                divide_edge(e[0], e[1]);
            }
        }
        missing = missing_edges();
    }
}

bool BoundaryRecovery::recover_edge(int a, int b, int depth) {
    for (int step = 0; step < kMostFlips; ++step) {
        if (mesh_.cell_with(a, b) >= 0) {
            return true;
        }
        calls_ = 0;
        const bool even = step % 2 == 0;
        if (!advance(even ? a : b, even ? b : a, depth) && !advance(even ? b : a, even ? a : b, depth)) {
            // Attempts that failed may have made the edge nevertheless.
            return mesh_.cell_with(a, b) >= 0;
        }
    }
    return false;
}

/// Flips the first obstacle on the way from a to b away.
bool BoundaryRecovery::advance(int a, int b, int depth) {
    Obstacle obstacle;
    if (!obstacle_on(a, b, obstacle)) {
        return false;
    }
    const auto& v = obstacle.v;
    if (v[2] < 0) {
        return remove_edge(v[0], v[1], depth, a, b) || remove_edge(v[0], v[1], depth, -1, -1);
    }
    const int face = mesh_.index_of(obstacle.cell, a);
    if (!surface_.has_triangle(v[0], v[1], v[2]) && flipper_.flip_face(obstacle.cell, face, FlipRule())) {
        return true;
    }
    const int other = mesh_.cells[obstacle.cell].n[face];
    const int apex = mesh_.cells[other].v[mesh_.face_towards(other, obstacle.cell)];
    for (std::size_t k = 0; k < 3; ++k) {
        // The edges over which the two cells are not convex.
        if (mesh_.orient(a, v[k], v[(k + 1) % 3], apex) >= 0 && remove_edge(v[k], v[(k + 1) % 3], depth, -1, -1)) {
            return true;
        }
    }
    return false;
}

bool BoundaryRecovery::obstacle_on(int a, int b, Obstacle& found) {
    mesh_.star(a, star_);
    for (const int cell : star_) {
        const int(&f)[3] = kFaceOf[mesh_.index_of(cell, a)];
        const std::array<int, 4>& v = mesh_.cells[cell].v;
        std::array<int, 3> side{};
        for (int k = 0; k < 3; ++k) {
            side[k] = mesh_.orient(a, v[f[k]], v[f[(k + 1) % 3]], b);
        }
        const auto zeros = std::count(side.begin(), side.end(), 0);
        if (*std::max_element(side.begin(), side.end()) > 0) {
            continue;
        }
        if (mesh_.has(cell, b)) {
            return false;
        }
        if (zeros > 1) {
            throw MeshingFailed(phrases::kVertexOnEdge);
        }
        found.cell = cell;
        found.v = {v[f[0]], v[f[1]], v[f[2]]};
        if (zeros == 1) {
            const auto k = std::find(side.begin(), side.end(), 0) - side.begin();
            found.v = {v[f[k]], v[f[(k + 1) % 3]], -1};
        }
        return true;
    }
    return false;
}

/// Removes an edge; where its ring cannot be tetrahedralised without it, the ring is made smaller first by the removal
/// of edges between the ends and the ring.
bool BoundaryRecovery::remove_edge(int p, int q, int depth, int chord_a, int chord_b) {
    if (surface_.has_edge(p, q) || ++calls_ > kMostCalls) {
        return false;
    }
    FlipRule rule;
    rule.chord_a = chord_a;
    rule.chord_b = chord_b;
    if (flipper_.remove_edge(p, q, rule)) {
        return true;
    }
    EdgeRing ring;
    if (depth == 0 || !mesh_.ring(p, q, ring)) {
        return false;
    }
    for (const int x : ring.x) {
        if (x == chord_a || x == chord_b) {
            continue;
        }
        if ((remove_edge(p, x, depth - 1, -1, -1) || remove_edge(q, x, depth - 1, -1, -1)) &&
            (mesh_.cell_with(p, q) < 0 || flipper_.remove_edge(p, q, rule))) {
            return true;
        }
    }
    return false;
}

void BoundaryRecovery::recover_triangles(Triangles missing) {
    for (const int depth : kDepths) {
        Triangles left;
        for (const auto& t : missing) {
            progress_.check();
            if (!recover_triangle(t, depth)) {
                left.push_back(t);
            }
        }
        missing = std::move(left);
    }
    for (const auto& t : missing) {
        if (mesh_.cell_with(t[0], t[1], t[2]) < 0) {
            divide_triangle(t);
        }
    }
}

bool BoundaryRecovery::recover_triangle(const SurfaceConstraints::Triangle& t, int depth) {
    for (int step = 0; step < kMostFlips; ++step) {
        if (mesh_.cell_with(t[0], t[1], t[2]) >= 0) {
            return true;
        }
        if (!remove_piercing(t, depth)) {
            return false;
        }
    }
    return false;
}

/// Removes an edge through the triangle, as seen from any of its sides.
bool BoundaryRecovery::remove_piercing(const SurfaceConstraints::Triangle& t, int depth) {
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<int, 2> edge{};
        calls_ = 0;
        if (piercing_edge({t[k], t[(k + 1) % 3], t[(k + 2) % 3]}, edge) &&
            remove_edge(edge[0], edge[1], depth, -1, -1)) {
            return true;
        }
    }
    return false;
}

/// The edge through the triangle that is nearest its first side.
bool BoundaryRecovery::piercing_edge(const SurfaceConstraints::Triangle& t, std::array<int, 2>& edge) {
    const int a = t[0];
    const int b = t[1];
    if (!mesh_.ring(a, b, ring_)) {
        return false;
    }
    for (std::size_t i = 0; i < ring_.x.size(); ++i) {
        const int x = ring_.x[i];
        const int y = ring_.x[(i + 1) % ring_.x.size()];
        if (mesh_.orient(a, b, x, t[2]) > 0 && mesh_.orient(a, b, t[2], y) > 0) {
            edge = {x, y};
            return true;
        }
    }
    return false;
}

void BoundaryRecovery::count_division() {
    if (++count_.divisions > kMostDivisions + mesh_.points.size() / 2) {
        throw MeshingFailed(phrases::kNotRecovered);
    }
}

namespace {

/// The fraction of the way from a to b at which the line meets the plane; 0.5 if that is nearer an end than `least`.
double fraction_at(const Vec3& a, const Vec3& b, const Vec3& on_plane, const Vec3& normal, double least) {
    const double along = (b - a).dot(normal);
    const double fraction = along != 0.0 ? (on_plane - a).dot(normal) / along : 0.5;
    return fraction > least && fraction < 1.0 - least ? fraction : 0.5;
}

}  // namespace

void BoundaryRecovery::divide_edge(int a, int b) {
    Obstacle obstacle;
    if (!obstacle_on(a, b, obstacle)) {
        throw MeshingFailed(phrases::kEdgeLeadsNowhere);
    }
    const auto& v = obstacle.v;
    const Vec3& from = mesh_.point(a);
    const Vec3& to = mesh_.point(b);
    std::vector<int> cavity;
    Vec3 normal;
    if (v[2] < 0) {
        if (surface_.has_edge(v[0], v[1])) {
            throw MeshingFailed(phrases::kEdgesCross);
        }
        const Vec3 across = mesh_.point(v[1]) - mesh_.point(v[0]);
        normal = across.cross((to - from).cross(across));
        mesh_.ring(v[0], v[1], ring_);
        cavity = ring_.cells;
    } else {
        if (surface_.has_triangle(v[0], v[1], v[2])) {
            throw MeshingFailed(phrases::kEdgeCrossesTriangle);
        }
        normal = (mesh_.point(v[1]) - mesh_.point(v[0])).cross(mesh_.point(v[2]) - mesh_.point(v[0]));
        cavity = {obstacle.cell, mesh_.cells[obstacle.cell].n[mesh_.index_of(obstacle.cell, a)]};
    }
    const double fraction = fraction_at(from, to, mesh_.point(v[0]), normal, least_fraction_);
    count_division();
    surface_.divide_edge(a, b, insert(from + fraction * (to - from), cavity));
}

void BoundaryRecovery::divide_triangle(const SurfaceConstraints::Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<int, 2> edge{};
        if (!piercing_edge({t[k], t[(k + 1) % 3], t[(k + 2) % 3]}, edge)) {
            continue;
        }
        if (surface_.has_edge(edge[0], edge[1])) {
            throw MeshingFailed(phrases::kEdgeCrossesTriangle);
        }
        const Vec3 normal = (mesh_.point(t[1]) - mesh_.point(t[0])).cross(mesh_.point(t[2]) - mesh_.point(t[0]));
        const Vec3& from = mesh_.point(edge[0]);
        const Vec3& to = mesh_.point(edge[1]);
        const double fraction = fraction_at(from, to, mesh_.point(t[0]), normal, 1e-6);
        mesh_.ring(edge[0], edge[1], ring_);
        const std::vector<int> cavity = ring_.cells;
        count_division();
        surface_.divide_triangle(t, insert(from + fraction * (to - from), cavity));
        return;
    }
    throw MeshingFailed(phrases::kVertexInTriangle);
}

/// Inserts a point into the cells that it should divide or, if that fails, into the cell that contains it.
int BoundaryRecovery::insert(const Vec3& p, const std::vector<int>& cells) {
    StarCavity cavity(mesh_, surface_);
    if (!cavity.open(p, cells, -1, {})) {
        const int cell = Locator(mesh_).find(p, cells.front());
        if (cell < 0 || !cavity.open(p, {cell}, -1, {})) {
            throw MeshingFailed(phrases::kPointWithoutPlace);
        }
    }
    const int vertex = mesh_.add_point(p);
    std::vector<int> created;
    mesh_.replace(cavity.cells(), cavity.cells_of(vertex), created);
    return vertex;
}

}  // namespace mq::tetrahedralise

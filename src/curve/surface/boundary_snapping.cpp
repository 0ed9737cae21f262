// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <set>
#include <tuple>

#include "curve/surface/editor.h"
#include "curve/surface/tuning.h"

namespace mq::curve {

namespace {

/// A vertex that has come to lie on a CAD edge.
struct Snap {
    int vertex;
    double t;
    Vec3 point;
};

/// A mesh edge on a CAD edge, and the vertices that belong between its ends.
class Snapping {
  public:
    Snapping(SurfaceEditor& editor, int triangle, int a, int b)
        : editor_(editor),
          surface_(editor.surface),
          face_(editor.triangle(triangle).face),
          edge_(surface_.segment(a, b)->edge),
          a_(a),
          b_(b) {
        follow(a, surface_.t_of(a, b), b, surface_.t_of(b, a), triangle);
    }

    int count() const { return static_cast<int>(snaps_.size()); }

    bool carry_out(SurfaceEditor::Rule rule) {
        const std::vector<int> removed = touched();
        const std::vector<SurfaceEditor::Corners> added = replacement(removed);
        const Before before = keep(removed);
        move_vertices();
        if (editor_.replace(removed, added, rule)) {
            return true;
        }
        restore(before, removed);
        return false;
    }

  private:
    struct Before {
        std::vector<elements::Vertex> vertices;
        std::vector<Vec2> uv;
        std::vector<std::pair<std::pair<int, int>, std::vector<Vec3>>> edges;
    };

    /// Handles the section between (a, t_a) and (b, t_b): where the triangle on it has its third vertex on the CAD edge
    /// between them, that triangle has no area once curved, and the two other edges follow the CAD edge.
    void follow(int a, double t_a, int b, double t_b, int triangle) {
        const auto& corners = editor_.triangle(triangle).corners;
        const int x = *std::find_if(corners.begin(), corners.end(), [&](int v) { return v != a && v != b; });
        Snap snap{x, 0.0, Vec3::Zero()};
        const bool fresh = std::none_of(snaps_.begin(), snaps_.end(), [&](const Snap& s) { return s.vertex == x; });
        if (!fresh || surface_.shapes.vertices[static_cast<std::size_t>(x)].entity[0] != 2 ||
            !editor_.placement.on_edge(x, edge_, t_a, t_b, SurfaceTuning::kHugs * bulge(a, b), snap.t, snap.point)) {
            return;
        }
        flat_.push_back(triangle);
        for (const auto& [from, t_from, to, t_to] : {std::tuple{a, t_a, x, snap.t}, std::tuple{x, snap.t, b, t_b}}) {
            if (from == x) {
                snaps_.push_back(snap);
            }
            for (const int other : surface_.triangles_of_edge(from, to)) {
                if (other != triangle && editor_.triangle(other).face == face_) {
                    follow(from, t_from, to, t_to, other);
                }
            }
        }
    }

    /// An estimate of the CAD edge's distance from the chord between two vertices on it, mm.
    double bulge(int a, int b) const {
        const double part = editor_.length(a, b) / editor_.length(a_, b_);
        return part * part * editor_.deviation(a_, b_);
    }

    /// All triangles at the vertices that move, and those beyond the old mesh edge.
    std::vector<int> touched() const {
        const std::vector<int> beside = surface_.triangles_of_edge(a_, b_);
        std::set<int> result(beside.begin(), beside.end());
        for (const Snap& snap : snaps_) {
            const std::vector<int>& star = surface_.triangles_of_vertex(snap.vertex);
            result.insert(star.begin(), star.end());
        }
        return {result.begin(), result.end()};
    }

    std::vector<SurfaceEditor::Corners> replacement(const std::vector<int>& removed) const {
        const std::vector<int> beyond = surface_.triangles_of_edge(a_, b_);
        std::vector<SurfaceEditor::Corners> added;
        for (const int t : removed) {
            if (std::find(flat_.begin(), flat_.end(), t) != flat_.end()) {
                continue;
            }
            const SurfaceTriangle& triangle = editor_.triangle(t);
            if (std::find(beyond.begin(), beyond.end(), t) == beyond.end()) {
                added.push_back({triangle.corners, triangle.face});
                continue;
            }
            for (std::size_t i = 0; i <= snaps_.size(); ++i) {
                std::array<int, 3> corners = triangle.corners;
                std::replace(corners.begin(), corners.end(), a_, i == 0 ? a_ : snaps_[i - 1].vertex);
                std::replace(corners.begin(), corners.end(), b_, i == snaps_.size() ? b_ : snaps_[i].vertex);
                added.push_back({corners, triangle.face});
            }
        }
        return added;
    }

    Before keep(const std::vector<int>& removed) const {
        Before before;
        for (const Snap& snap : snaps_) {
            before.vertices.push_back(surface_.shapes.vertices[static_cast<std::size_t>(snap.vertex)]);
            before.uv.push_back(*surface_.uv_of(snap.vertex, face_));
        }
        for (const int t : removed) {
            const auto& v = editor_.triangle(t).corners;
            for (std::size_t k = 0; k < 3; ++k) {
                if (surface_.shapes.has_edge(v[k], v[(k + 1) % 3])) {
                    before.edges.push_back({{v[k], v[(k + 1) % 3]}, surface_.shapes.edge_inner(v[k], v[(k + 1) % 3])});
                }
            }
        }
        return before;
    }

    /// Edges at the vertices lose their shapes, and get new ones from the new places of the vertices.
    void move_vertices() {
        int from = a_;
        double t_from = surface_.t_of(a_, b_);
        const double t_b = surface_.t_of(b_, a_);
        for (const Snap& snap : snaps_) {
            for (const int t : surface_.triangles_of_vertex(snap.vertex)) {
                for (const int v : editor_.triangle(t).corners) {
                    surface_.shapes.forget_edge(snap.vertex, v);
                }
            }
            surface_.shapes.vertices[static_cast<std::size_t>(snap.vertex)] = {snap.point, {1, edge_}};
            editor_.placement.set_uv_on_edge(snap.vertex, edge_, snap.t);
            surface_.set_segment(from, snap.vertex, edge_, t_from, snap.t);
            from = snap.vertex;
            t_from = snap.t;
        }
        surface_.set_segment(from, b_, edge_, t_from, t_b);
    }

    void restore(const Before& before, const std::vector<int>& removed) {
        int from = a_;
        for (std::size_t i = 0; i < snaps_.size(); ++i) {
            surface_.segments.erase(pair_key(from, snaps_[i].vertex));
            from = snaps_[i].vertex;
            surface_.shapes.vertices[static_cast<std::size_t>(from)] = before.vertices[i];
            surface_.uv[CurvedSurface::key(from, face_)] = before.uv[i];
        }
        surface_.segments.erase(pair_key(from, b_));
        for (const auto& [ends, inner] : before.edges) {
            surface_.shapes.set_edge(ends.first, ends.second, inner);
        }
        editor_.placement.place(removed);
    }

    SurfaceEditor& editor_;
    CurvedSurface& surface_;
    int face_;
    int edge_;
    int a_;
    int b_;
    std::vector<Snap> snaps_;  // sorted from a to b
    std::vector<int> flat_;
};

}  // namespace

namespace {

/// Tries each side of the triangle that lies on a CAD edge.
int snap_at(SurfaceEditor& editor, int triangle, SurfaceEditor::Rule rule) {
    const auto v = editor.triangle(triangle).corners;
    for (std::size_t k = 0; k < 3; ++k) {
        if (editor.surface.segment(v[k], v[(k + 1) % 3]) == nullptr) {
            continue;
        }
        Snapping snapping(editor, triangle, v[k], v[(k + 1) % 3]);
        if (snapping.count() > 0 && snapping.carry_out(rule)) {
            return snapping.count();
        }
    }
    return 0;
}

}  // namespace

int snap_to_boundary(SurfaceEditor& editor, int triangle, SurfaceEditor::Rule rule) {
    const SurfaceTriangle bad = editor.triangle(triangle);
    int snapped = snap_at(editor, triangle, rule);
    for (std::size_t k = 0; k < 3 && snapped == 0; ++k) {
        const std::vector<int> around = editor.surface.triangles_of_vertex(bad.corners[k]);
        for (std::size_t i = 0; i < around.size() && snapped == 0; ++i) {
            snapped = editor.triangle(around[i]).face == bad.face ? snap_at(editor, around[i], rule) : 0;
        }
    }
    return snapped;
}

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/repair.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "base/tuning.h"
#include "curve/surface/tuning.h"

namespace mq::curve {

namespace {

class Repair {
  public:
    /// @param reach whether elements may leave the CAD towards vertices that deviate from it.
    Repair(SurfaceEditor& editor, const Progress& progress, RepairScope scope, bool reach)
        : editor_(editor),
          progress_(progress),
          scope_(scope),
          good_(scope == RepairScope::Poor ? SurfaceTuning::kGoodTriangle : std::numeric_limits<double>::min()),
          reach_(reach) {}

    SurfaceRepairs run() {
        done_.invalid_before = invalid();
        if (reach_) {
            reach_all();
        }
        for (int round = 0; scope_ == RepairScope::Poor && round < SurfaceTuning::kHalvingRounds && split_bulging();
             ++round) {
        }
        for (int round = 0; round < kMostRounds && snap_all(); ++round) {
        }
        for (int round = 0; round < kMostRounds && repair_round(round); ++round) {
        }
        while (refine_faces()) {
        }
        done_.invalid_after = invalid();
        return done_;
    }

  private:
    /// Changes of a triangle that repairs leave invalid; they are made whether or not they help at once.
    enum class Way { Snap, Collapse, Split };

    /// Some faces need several changes at once. If coarse edges deviate by more than the height of the triangles at
    /// them, halving a triangle leaves two invalid ones: only finer triangles fit. And a single vertex that is snapped
    /// to a border or collapsed into its neighbour may fold a triangle that several such changes repair. So each face
    /// in turn is changed around its invalid triangles, with repairs in between.
    /// @return whether fewer triangles are invalid, so that repeating it ends
    bool refine_faces() {
        bool any = false;
        std::set<int> faces;
        for (const SurfaceTriangle& t : editor_.surface.triangles) {
            if (t.alive && !(t.quality > 0.0)) {
                faces.insert(t.face);
            }
        }
        for (const int face : faces) {
            for (const Way way : {Way::Snap, Way::Collapse, Way::Split}) {
                any = refine_best(face, way) || any;
            }
        }
        return any;
    }

    /// @return whether fewer triangles are invalid: all changes after the fewest were reached are reverted.
    bool refine_best(int face, Way way) {
        int fewest = invalid();
        CurvedSurface best = editor_.surface;
        SurfaceRepairs done = done_;
        bool better = false;
        for (int round = 0; round < kMostRounds && refine_face(face, way); ++round) {
            const int now = invalid();
            if (now > SurfaceTuning::kRunaway * (fewest + 4)) {
                break;
            }
            if (now < fewest) {
                fewest = now;
                best = editor_.surface;
                done = done_;
                better = true;
            }
        }
        editor_.surface = std::move(best);
        done_ = done;
        done_.refined_faces += better ? 1 : 0;
        return better;
    }

    bool refine_face(int face, Way way) {
        bool any = false;
        const std::size_t count = editor_.surface.triangles.size();
        for (std::size_t i = 0; i < count; ++i) {
            const int t = static_cast<int>(i);
            const auto open = [&] { return editor_.triangle(t).alive && !(editor_.triangle(t).quality > 0.0); };
            if (editor_.triangle(t).face != face || !open()) {
                continue;
            }
            progress_.check();
            any = true;
            repair(t, 1);
            if (open() && way == Way::Collapse) {
                done_.collapses += collapse_shortest(editor_.triangle(t).corners, SurfaceEditor::Rule::Try) ? 1 : 0;
            } else if (open() && way == Way::Snap) {
                done_.snapped += snap_to_boundary(editor_, t, SurfaceEditor::Rule::Try);
            } else if (open()) {
                const auto [a, b] = edge_to_split_around(t);
                done_.splits += split_surface_edge(editor_, a, b, SurfaceEditor::Rule::Try) >= 0 ? 1 : 0;
            }
        }
        return any;
    }

    double hardly_valid() const { return std::min(SurfaceTuning::kHardlyValid, good_); }

    int invalid() const { return static_cast<int>(editor_.surface.invalid()); }

    /// Lets nodes leave the CAD towards all vertices off the CAD, before edges are split that bend only because they
    /// lead to such a vertex.
    void reach_all() {
        const std::size_t count = editor_.surface.triangles.size();
        for (std::size_t t = 0; t < count; ++t) {
            if (editor_.surface.triangles[t].alive && editor_.surface.triangles[t].quality < good_) {
                progress_.check();
                done_.reached += relax_to_off_cad_vertices(editor_, static_cast<int>(t));
            }
        }
    }

    bool split_bulging() {
        std::vector<std::pair<int, int>> edges;
        for (const SurfaceTriangle& t : editor_.surface.triangles) {
            for (std::size_t k = 0; k < 3 && t.alive; ++k) {
                const int a = t.corners[k];
                const int b = t.corners[(k + 1) % 3];
                if (a < b && editor_.deviation(a, b) > SurfaceTuning::kAllowableBulge * editor_.length(a, b)) {
                    edges.emplace_back(a, b);
                }
            }
        }
        bool any = false;
        for (const auto& [a, b] : edges) {
            progress_.check();
            if (editor_.surface.has_edge(a, b) && split_surface_edge(editor_, a, b, SurfaceEditor::Rule::Refine) >= 0) {
                ++done_.bulge_splits;
                any = true;
            }
        }
        return any;
    }

    /// Snaps all vertices that lie on a border, before other repairs separate the rows of such vertices.
    bool snap_all() {
        int snapped = 0;
        const std::size_t count = editor_.surface.triangles.size();
        for (std::size_t t = 0; t < count; ++t) {
            if (editor_.surface.triangles[t].alive && editor_.surface.triangles[t].quality <= hardly_valid()) {
                progress_.check();
                snapped += snap_to_boundary(editor_, static_cast<int>(t), SurfaceEditor::Rule::Refine);
            }
        }
        done_.snapped += snapped;
        return snapped > 0;
    }

    /// @return whether anything changed.
    bool repair_round(int round) {
        std::vector<std::pair<double, int>> bad;
        for (std::size_t t = 0; t < editor_.surface.triangles.size(); ++t) {
            const SurfaceTriangle& triangle = editor_.surface.triangles[t];
            if (triangle.alive && triangle.quality < good_) {
                bad.emplace_back(triangle.quality, static_cast<int>(t));
            }
        }
        std::sort(bad.begin(), bad.end());
        bool any = false;
        for (const auto& [quality, t] : bad) {
            progress_.check();
            if (editor_.triangle(t).alive && editor_.triangle(t).quality < good_) {
                any = repair(t, round) || any;
            }
        }
        return any;
    }

    bool repair(int t, int round) {
        const std::array<int, 3> v = editor_.triangle(t).corners;
        const int reached = reach_ ? relax_to_off_cad_vertices(editor_, t) : 0;
        if (reached > 0) {
            done_.reached += reached;
            return true;
        }
        const int snapped = editor_.triangle(t).quality > hardly_valid()
                                ? 0
                                : snap_to_boundary(editor_, t, SurfaceEditor::Rule::Refine);
        if (snapped > 0) {
            done_.snapped += snapped;
            return true;
        }
        if (!(editor_.triangle(t).quality > 0.0) && follow_parameters(editor_, t)) {
            ++done_.followed;
            return true;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (swap_surface_edge(editor_, v[k], v[(k + 1) % 3])) {
                ++done_.swaps;
                return true;
            }
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const CuspRepair cusp = open_cusp(editor_, v[k], v[(k + 1) % 3], v[(k + 2) % 3]);
            if (cusp != CuspRepair::None) {
                done_.cusps += cusp == CuspRepair::Opened ? 1 : 0;
                done_.cusp_splits += cusp == CuspRepair::Refined ? 1 : 0;
                return true;
            }
        }
        if (!(editor_.triangle(t).quality > 0.0) && retriangulate_cavity(editor_, t)) {
            ++done_.regrown;
            return true;
        }
        // Collapses make the mesh coarser: only short edges are collapsed, and only after a round of splits.
        if (round > 0 && (collapse_shortest(v, SurfaceEditor::Rule::Improve) ||
                          (!(editor_.triangle(t).quality > 0.0) && collapse_any(v)))) {
            ++done_.collapses;
            return true;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (curve_beside(v[k], v[(k + 1) % 3], v[(k + 2) % 3])) {
                ++done_.curved_edges;
                return true;
            }
        }
        const auto [a, b] = edge_to_split(v);
        if (split_surface_edge(editor_, a, b, SurfaceEditor::Rule::Refine) >= 0) {
            ++done_.splits;
            return true;
        }
        return false;
    }

    /// Curves one of the two edges of a triangle that meet in vertex a away from the other one.
    bool curve_beside(int a, int b, int c) {
        return curve_face_edge(editor_, a, b, c) || curve_face_edge(editor_, a, c, b);
    }

    bool collapse_shortest(const std::array<int, 3>& v, SurfaceEditor::Rule rule) {
        std::size_t shortest = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if (editor_.length(v[k], v[(k + 1) % 3]) < editor_.length(v[shortest], v[(shortest + 1) % 3])) {
                shortest = k;
            }
        }
        const int a = v[shortest];
        const int b = v[(shortest + 1) % 3];
        return collapse_surface_edge(editor_, a, b, rule) || collapse_surface_edge(editor_, b, a, rule);
    }

    /// Vertices inside a face that lie on its border within tolerance, behind its coarser edges, can only be removed.
    bool collapse_any(const std::array<int, 3>& v) {
        for (const int a : v) {
            if (editor_.surface.shapes.vertices[static_cast<std::size_t>(a)].entity[0] != 2) {
                continue;
            }
            std::set<int> neighbours;
            for (const int t : editor_.surface.triangles_of_vertex(a)) {
                neighbours.insert(editor_.triangle(t).corners.begin(), editor_.triangle(t).corners.end());
            }
            neighbours.erase(a);
            const auto rule = SurfaceEditor::Rule::Improve;
            for (const int b : neighbours) {
                if (collapse_surface_edge(editor_, a, b, rule)) {
                    return true;
                }
            }
        }
        return false;
    }

    /// An edge of a triangle, and its deviation from the chord relative to the height of the triangle on it.
    struct Bulge {
        std::pair<int, int> edge{-1, -1};
        double ratio = 0.0;
    };

    /// The edge with the largest deviation relative to the height of the triangle on it.
    Bulge most_bulging(const std::array<int, 3>& v) const {
        const Vec3 normal =
            (editor_.point(v[1]) - editor_.point(v[0])).cross(editor_.point(v[2]) - editor_.point(v[0]));
        Bulge most;
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = v[k];
            const int b = v[(k + 1) % 3];
            const double edge = editor_.length(a, b);
            const double height = normal.norm() / edge;
            const double ratio = editor_.deviation(a, b) / std::max(height, 1e-12 * edge);
            if (ratio > most.ratio || most.edge.first < 0) {
                most = {{a, b}, ratio};
            }
        }
        return most;
    }

    std::pair<int, int> longest(const std::array<int, 3>& v) const {
        std::size_t at = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if (editor_.length(v[k], v[(k + 1) % 3]) > editor_.length(v[at], v[(at + 1) % 3])) {
                at = k;
            }
        }
        return {v[at], v[(at + 1) % 3]};
    }

    /// The edge with the largest deviation relative to the triangle's height; the longest where all edges are straight.
    std::pair<int, int> edge_to_split(const std::array<int, 3>& v) const {
        const Bulge bulge = most_bulging(v);
        return bulge.ratio > SurfaceTuning::kBulges ? bulge.edge : longest(v);
    }

    /// The edge to split of the triangle and of its neighbours on the face: a triangle may be folded by an edge of its
    /// neighbour behind which its vertices lie.
    std::pair<int, int> edge_to_split_around(int t) const {
        const SurfaceTriangle& bad = editor_.triangle(t);
        Bulge most = most_bulging(bad.corners);
        for (const int v : bad.corners) {
            for (const int other : editor_.surface.triangles_of_vertex(v)) {
                if (editor_.triangle(other).face == bad.face) {
                    const Bulge bulge = most_bulging(editor_.triangle(other).corners);
                    most = bulge.ratio > most.ratio ? bulge : most;
                }
            }
        }
        return most.ratio > SurfaceTuning::kBulges ? most.edge : longest(bad.corners);
    }

    SurfaceEditor& editor_;
    const Progress& progress_;
    RepairScope scope_;
    double good_;  // quality from which triangles stay as they are
    bool reach_;
    SurfaceRepairs done_;
};

}  // namespace

SurfaceRepairs repair_surface(SurfaceEditor& editor, const Progress& progress, RepairScope scope) {
    bool any_off = false;
    for (std::size_t v = 0; v < editor.surface.shapes.vertices.size() && !any_off; ++v) {
        any_off = editor.placement.may_be_off_cad(static_cast<int>(v));
    }
    if (!any_off) {
        return Repair(editor, progress, scope, false).run();
    }
    const CurvedSurface before = editor.surface;
    const SurfaceRepairs reached = Repair(editor, progress, scope, true).run();
    if (reached.reached == 0 || reached.invalid_after == 0) {
        return reached;
    }
    // Leaving the CAD repairs one place, and may prevent repairs at another one.
    const CurvedSurface kept = std::exchange(editor.surface, before);
    const SurfaceRepairs plain = Repair(editor, progress, scope, false).run();
    if (plain.invalid_after < reached.invalid_after) {
        return plain;
    }
    editor.surface = kept;
    return reached;
}

}  // namespace mq::curve

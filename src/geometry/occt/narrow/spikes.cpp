// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/spikes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/angle.h"
#include "base/message.h"
#include "base/predicates.h"
#include "geometry/detail.h"
#include "geometry/occt/narrow/edge_joining.h"

namespace mq::geometry {

namespace {

class Spikes : EdgeJoining {
  public:
    Spikes(Topology& topology, ShapeMap& live, const Progress* progress)
        : EdgeJoining(topology, live), progress_(progress) {}

    bool run() {
        bool any = false;
        for (Face& face : topology_.faces) {
            check_cancelled(progress_);
            for (Loop& loop : face.loops) {
                while (remove_one(loop)) {
                    any = true;
                }
            }
        }
        rename_nodes();
        return any;
    }

  private:
    static constexpr double kWidestTip = 45.0 * kDegree;  // Radians: between its sides.
    // Fraction of the shorter of two edges at whose end one triangle spans what is not told apart (unresolved_ends).
    static constexpr double kSpanned = 0.02;

    /// Two neighbouring edges of a loop as the sides of a spike; edges shorter than the detail may lie between them.
    struct Sides {
        int longer;             // use of the edge that goes on beyond the spike
        int shorter;            // use of the edge that ends at the inside of the longer one, or at its end
        int beyond;             // the use after the shorter one, away from the tip
        int before;             // the use before the longer one, away from the tip
        std::vector<int> tips;  // uses of the short edges
        bool ascending;         // whether the loop walks the longer edge first
    };
    struct Spike {
        Sides sides;
        int node;       // at the far end of the shorter edge
        bool whole;     // whether both edges end at the mouth of the spike: the longer one is not divided
        double t;       // parameter of the longer edge at the foot
        double within;  // largest distance between the sides of the spike, mm
    };

    bool remove_one(Loop& loop) {
        const std::size_t n = loop.uses.size();
        for (std::size_t i = 0; i < n; ++i) {
            Sides sides{loop.uses[i], -1, -1, loop.uses[(i + n - 1) % n], {}, true};
            std::size_t k = i + 1;
            for (; k < i + n && is_short(edge_of(loop.uses[k % n])); ++k) {
                sides.tips.push_back(loop.uses[k % n]);
            }
            if (n < sides.tips.size() + 3 || is_short(edge_of(sides.longer))) {
                continue;
            }
            sides.shorter = loop.uses[k % n];
            sides.beyond = loop.uses[(k + 1) % n];
            const Sides other{sides.shorter, sides.longer, sides.before, sides.beyond, sides.tips, false};
            for (const Sides& both : {sides, other}) {
                const std::optional<Spike> spike = spike_between(both);
                if (spike && cut_off(loop, *spike)) {
                    return true;
                }
            }
            if (sides.tips.empty() && join_indistinct(loop, sides.longer, sides.shorter)) {
                return true;
            }
        }
        return false;
    }

    std::optional<Spike> spike_between(const Sides& sides) const {
        const int a = edge_of(sides.longer);
        const int b = edge_of(sides.shorter);
        if (!parts_two_faces(sides.longer) || !parts_two_faces(sides.shorter) || a == b ||
            tip_angle(sides) >= kWidestTip) {
            return std::nullopt;
        }
        const double own = tolerance(a) + tolerance(b);
        const double within = std::max(own, topology_.detail);
        const std::optional<Alignment> along = alignment(b, a, within);
        if (!along) {
            return std::nullopt;
        }
        const int node = edge(b).nodes[use_of(sides.shorter).forward == sides.ascending ? 1 : 0];
        const Vec3& end = topology_.nodes[static_cast<std::size_t>(node)].point;
        const Answer foot = nearest_on(a, end, within);
        const bool whole = foot.found() && !is_inside(a, foot, within);
        if (!foot.found() || !(whole ? mouth_opens(sides, node) : opens(sides, foot))) {
            return std::nullopt;
        }
        const bool same = !whole && sides.tips.empty() && along->distance <= own;
        if (!same &&
            !(others_open(sides.shorter, sides.longer) &&
              std::all_of(sides.tips.begin(), sides.tips.end(), [&](int tip) { return leaves_corner_beside(tip); }))) {
            return std::nullopt;
        }
        return Spike{sides, node, whole, foot.t, within};
    }

    /// Radians: the angle between the directions in which both edges leave the tip.
    double tip_angle(const Sides& sides) const {
        constexpr double kStep = 0.01;  // Fraction of the edges' ranges over which their directions are measured.
        return angle_between(direction_at(sides.longer, !sides.ascending, kStep),
                             direction_at(sides.shorter, sides.ascending, kStep));
    }

    /// Direction from an end of a use into its edge: from its start forward, or from its end backward.
    Vec3 direction_at(int use, bool from_start, double step) const {
        const EdgeEvaluator& along = curve(edge_of(use));
        const double end = use_of(use).forward == from_start ? 0.0 : 1.0;
        const double beside = end + (end > 0.0 ? -step : step);
        return along.point(parameter(edge_of(use), beside)).point - along.point(parameter(edge_of(use), end)).point;
    }

    /// Whether a point of an edge is farther than this from both of its nodes.
    bool is_inside(int e, const Answer& there, double within) const {
        return std::all_of(edge(e).nodes.begin(), edge(e).nodes.end(), [&](int node) {
            return (topology_.nodes[static_cast<std::size_t>(node)].point - there.point).norm() > within;
        });
    }

    /// Whether the border turns from the longer edge, at the end of the shorter one, into the face by an angle of at
    /// least DetailCorners::kLeastAngle, or of at least the corner that the removal of the tip takes away. At a slit,
    /// whose other side the border passes, it turns away from the face.
    bool opens(const Sides& sides, const Answer& foot) const {
        const std::optional<Vec3> into = conormal(sides.longer, foot.t);
        const Vec3 leaving = point_along(sides.beyond, sides.ascending) - foot.point;
        const double least =
            sides.tips.empty() ? std::min(tip_angle(sides), DetailCorners::kLeastAngle) : DetailCorners::kLeastAngle;
        return into && angle_between(*into, leaving) <= 0.5 * M_PI - least;
    }

    /// Whether the longer edge ends within the detail of the node of the shorter one, and the edges that go on from
    /// there enclose DetailCorners::kLeastAngle.
    bool mouth_opens(const Sides& sides, int node) const {
        const int far = edge(edge_of(sides.longer)).nodes[use_of(sides.longer).forward == sides.ascending ? 0 : 1];
        const Vec3& mouth = topology_.nodes[static_cast<std::size_t>(node)].point;
        return sides.before != sides.beyond && far != node &&
               (topology_.nodes[static_cast<std::size_t>(far)].point - mouth).norm() <= topology_.detail &&
               angle_between(point_along(sides.before, !sides.ascending) - mouth,
                             point_along(sides.beyond, sides.ascending) - mouth) >= DetailCorners::kLeastAngle;
    }

    /// Whether the faces beyond the tip keep a corner where they lose its edge.
    bool leaves_corner_beside(int tip) const {
        const std::vector<int>& uses = edge(edge_of(tip)).uses;
        return std::all_of(uses.begin(), uses.end(), [&](int use) { return use == tip || leaves_corner(use); });
    }

    bool cut_off(Loop& loop, const Spike& spike) {
        const int a = edge_of(spike.sides.longer);
        const int b = edge_of(spike.sides.shorter);
        const int face = use_of(spike.sides.longer).face;
        const bool tip_is_last = use_of(spike.sides.longer).forward == spike.sides.ascending;
        const bool moved = spike.sides.tips.empty() && tip_angle(spike.sides) < DetailCorners::kLeastAngle;
        const int second = spike.whole ? a : divide(a, spike.t, spike.node);
        const int piece = tip_is_last ? second : a;
        if (!alignment(piece, b, spike.within) || !alignment(b, piece, spike.within)) {
            return false;
        }
        topology_.faults.push_back(topology_.name_of({2, face}) + ": has a spike between " + topology_.name_of({1, a}) +
                                   " and " + topology_.name_of({1, b}) + " that is no wider than " +
                                   in_digits(spike.within, 4) + " mm: it is left out");
        for (const int tip : spike.sides.tips) {
            Edge& end = edge(edge_of(tip));
            end.degenerate = true;
            unite(end.nodes[0], end.nodes[1]);
            drop(loop, tip);
        }
        drop(loop, use_on(piece, face));
        drop(loop, spike.sides.shorter);
        if (join(piece, b, spike.within) && moved) {
            topology_.joined.pop_back();  // the shape has this narrow corner already: it only moves
        }
        return true;
    }

    /// Two neighbouring uses of a loop, seen from their node.
    struct Tip {
        std::array<int, 2> uses;  // the first one ends in the node, the second one begins there
        std::array<int, 2> edges;
        std::array<bool, 2> at_last;  // whether the node is at the last parameter of the edge
        double tolerance;             // the larger one of both edges, mm
    };

    std::optional<Tip> tip_between(int before, int after) const {
        const auto has_curve = [&](int use) { return !live_.uses[static_cast<std::size_t>(use)].curve.IsNull(); };
        if (!parts_two_faces(before) || !parts_two_faces(after) || edge_of(before) == edge_of(after) ||
            !has_curve(before) || !has_curve(after) || tip_angle({before, after, -1, -1, {}, true}) >= kWidestTip) {
            return std::nullopt;
        }
        const std::array<int, 2> edges{edge_of(before), edge_of(after)};
        return Tip{{before, after},
                   edges,
                   {use_of(before).forward, !use_of(after).forward},
                   std::max(edge(edges[0]).tolerance, edge(edges[1]).tolerance)};
    }

    /// The image on the face of the point of the first edge of a tip (0), or of the second one (1), at a distance (mm)
    /// from their node; none where the edge comes nowhere as far from it.
    std::optional<Vec2> image_of(const Tip& tip, int k, double distance) const {
        const Answer there = point_at(tip.uses[k], k == 0, distance);
        if (!there.found()) {
            return std::nullopt;
        }
        const Edge& along = edge(tip.edges[k]);
        const PCurve& on_face = live_.uses[static_cast<std::size_t>(tip.uses[k])];
        const double share = (there.t - along.t0) / (along.t1 - along.t0);
        const gp_Pnt2d uv = on_face.curve->Value(on_face.first + share * (on_face.last - on_face.first));
        return Vec2(uv.X(), uv.Y());
    }

    /// Whether two segments have a point in common.
    static bool meet(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
        const Eigen::AlignedBox2d of_a(a0.cwiseMin(a1), a0.cwiseMax(a1));
        const Eigen::AlignedBox2d of_b(b0.cwiseMin(b1), b0.cwiseMax(b1));
        return of_a.intersects(of_b) && orient2d(a0, a1, b0) * orient2d(a0, a1, b1) <= 0 &&
               orient2d(b0, b1, a0) * orient2d(b0, b1, a1) <= 0;
    }

    /// The distance (mm) from their node, along the second edge of a tip, at which both curves cross or touch on the
    /// face; the farthest such place. Chords can cross where curves do not: their pieces are looked at again.
    std::optional<double> crossing(const Tip& tip, const std::array<std::array<double, 2>, 2>& ranges,
                                   int depth) const {
        constexpr int kPieces = 32;  // Chords of each range.
        const auto distance = [&](int k, int i) { return ranges[k][0] + (ranges[k][1] - ranges[k][0]) * i / kPieces; };
        std::array<std::array<std::optional<Vec2>, kPieces + 1>, 2> points;
        for (int k = 0; k < 2; ++k) {
            for (int i = 0; i <= kPieces; ++i) {
                points[k][i] = image_of(tip, k, distance(k, i));
            }
        }
        const auto& [a, b] = points;
        for (int j = kPieces - 1; j >= 0; --j) {
            for (int i = kPieces - 1; i >= 0; --i) {
                if (!a[i] || !a[i + 1] || !b[j] || !b[j + 1] || !meet(*a[i], *a[i + 1], *b[j], *b[j + 1])) {
                    continue;
                }
                const std::array<std::array<double, 2>, 2> here{
                    {{distance(0, i), distance(0, i + 1)}, {distance(1, j), distance(1, j + 1)}}};
                const std::optional<double> found = depth == 0 ? here[1][0] : crossing(tip, here, depth - 1);
                if (found) {
                    return found;
                }
            }
        }
        return std::nullopt;
    }

    /// Whether both edges of a tip are within their tolerance of each other at a distance (mm) from their node.
    bool is_together(const Tip& tip, double distance) const {
        const Answer there = point_at(tip.uses[1], false, distance);
        const Answer foot = there.found() ? nearest_on(tip.edges[0], there.point, tip.tolerance) : Answer{};
        return foot.found() && foot.distance <= tip.tolerance;
    }

    /// The distance (mm) from their node up to which both edges of a tip are one within their tolerance, if they cross
    /// or touch on the face on the way, and farther from the node than what else does not show there.
    std::optional<double> indistinct(const Tip& tip) const {
        constexpr double kMostOfEdge = 0.5;  // Fraction of the shorter edge.
        constexpr int kHalvings = 30;        // Below the least tolerance, 1e-7 mm, for edges of 200 mm.
        const double shorter = std::min(length(tip.edges[0]), length(tip.edges[1]));
        const double most = kMostOfEdge * shorter;
        const std::optional<double> crossed = crossing(tip, {{{0.0, most}, {0.0, most}}}, 2);
        const Node& node = topology_.nodes[static_cast<std::size_t>(edge(tip.edges[0]).nodes[tip.at_last[0] ? 1 : 0])];
        if (!crossed || *crossed <= std::max({tip.tolerance, node.tolerance, topology_.detail, kSpanned * shorter})) {
            return std::nullopt;
        }
        for (int i = 1; i <= kSamples; ++i) {
            if (!is_together(tip, *crossed * i / kSamples)) {
                return std::nullopt;
            }
        }
        double low = *crossed;
        double high = most;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (low + high);
            (is_together(tip, middle) ? low : high) = middle;
        }
        return low;
    }

    /// Makes one edge of two neighbours that cross or touch on the face beside their node, up to where their tolerance
    /// tells them apart.
    bool join_indistinct(Loop& loop, int before, int after) {
        const std::optional<Tip> tip = tip_between(before, after);
        const std::optional<double> up_to = tip ? indistinct(*tip) : std::nullopt;
        if (!up_to) {
            return false;
        }
        const int face = use_of(before).face;
        const Answer end = point_at(after, false, *up_to);
        const Answer foot = nearest_on(tip->edges[0], end.point, tip->tolerance);
        const int node = add_node(0.5 * (end.point + foot.point), tip->tolerance, {2, face});
        const std::array<double, 2> t{foot.t, end.t};
        std::array<int, 2> pieces;
        for (int k = 0; k < 2; ++k) {
            const int second = divide(tip->edges[k], t[k], node);
            pieces[k] = tip->at_last[k] ? second : tip->edges[k];
        }
        const double within = tolerance(pieces[0]) + tolerance(pieces[1]);
        if (!alignment(pieces[0], pieces[1], within) || !alignment(pieces[1], pieces[0], within)) {
            return false;
        }
        topology_.faults.push_back(topology_.name_of({2, face}) + ": " + topology_.name_of({1, tip->edges[0]}) +
                                   " and " + topology_.name_of({1, tip->edges[1]}) +
                                   " cross or coincide beside their vertex: they are one edge up to where they are " +
                                   in_digits(tip->tolerance, 4) + " mm apart, which is their tolerance");
        drop(loop, use_on(pieces[0], face));
        drop(loop, use_on(pieces[1], face));
        return join(pieces[0], pieces[1]);
    }

    const Progress* progress_;
};

}  // namespace

bool remove_spikes(Topology& topology, ShapeMap& live, const Progress* progress) {
    return Spikes(topology, live, progress).run();
}

}  // namespace mq::geometry

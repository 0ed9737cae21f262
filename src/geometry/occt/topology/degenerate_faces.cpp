// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/degenerate_faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/disjoint_sets.h"
#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/edge_evaluator.h"

namespace mq::geometry {

namespace {

class CollapsedPieces {
  public:
    CollapsedPieces(const OrderedShape& shape, Topology& topology, ShapeMap& live, const Progress* progress)
        : shape_(shape), topology_(topology), live_(live), progress_(progress), nodes_(topology.nodes.size()) {}

    void run() {
        for (int f = 0; f < static_cast<int>(topology_.faces.size()); ++f) {
            check_cancelled(progress_);
            Face& face = topology_.faces[static_cast<std::size_t>(f)];
            if (face.no_area && is_piece(f)) {
                take_out(f);
            } else if (!face.no_area && is_sliver(f)) {
                face.no_area = true;
                topology_.faults.push_back(topology_.name_of({2, f}) +
                                           ": is no wider than the tolerance of its edges, which count as one");
                take_out(f);
            }
        }
        join_folded_edges();
        for (Edge& edge : topology_.edges) {
            for (int& node : edge.nodes) {
                node = node < 0 ? node : nodes_.find(node);
            }
        }
    }

  private:
    /// Intervals along each parameter of a face, at whose ends its distance from an edge is measured.
    static constexpr int kSamples = 8;

    Edge& edge(int e) { return topology_.edges[static_cast<std::size_t>(e)]; }

    bool is_piece(int face) const { return shape_.is_cut(topology_.of_shape({2, face}).index); }

    /// Whether two edges bound the face, between the same nodes, and all of it lies within their tolerances of either.
    bool is_sliver(int face) {
        const Face& data = topology_.faces[static_cast<std::size_t>(face)];
        if (data.loops.size() != 1 || data.loops.front().uses.size() != 2) {
            return false;
        }
        const int a = topology_.uses[static_cast<std::size_t>(data.loops.front().uses[0])].edge;
        const int b = topology_.uses[static_cast<std::size_t>(data.loops.front().uses[1])].edge;
        if (a == b || !is_side(a) || !is_side(b)) {
            return false;
        }
        const auto [low_a, high_a] = std::minmax(edge(a).nodes[0], edge(a).nodes[1]);
        const auto [low_b, high_b] = std::minmax(edge(b).nodes[0], edge(b).nodes[1]);
        return low_a == low_b && high_a == high_b && run_alike(a, b) && run_alike(b, a) &&
               lies_along(face, a, tolerance(a) + tolerance(b));
    }

    /// Whether another face lies on the other side of an edge of a sliver.
    bool is_side(int e) {
        return !edge(e).degenerate && edge(e).uses.size() == 2 && edge(e).nodes[0] >= 0 && edge(e).nodes[1] >= 0 &&
               edge(e).nodes[0] != edge(e).nodes[1];
    }

    bool lies_along(int face, int e, double within) {
        const Face& data = topology_.faces[static_cast<std::size_t>(face)];
        const EdgeEvaluator along = curve(e);
        const BRepAdaptor_Surface surface(live_.faces[static_cast<std::size_t>(face)], Standard_False);
        for (int i = 0; i <= kSamples; ++i) {
            for (int k = 0; k <= kSamples; ++k) {
                const Vec3 p = to_vec(surface.Value(data.low[0] + (data.high[0] - data.low[0]) * i / kSamples,
                                                    data.low[1] + (data.high[1] - data.low[1]) * k / kSamples));
                const Answer foot = along.nearest(p, parameter(e, 0.5), edge(e).t0, edge(e).t1);
                if (!foot.found() || foot.distance > within) {
                    return false;
                }
            }
        }
        return true;
    }

    void take_out(int face) {
        std::set<int> around;
        for (const Loop& loop : topology_.faces[static_cast<std::size_t>(face)].loops) {
            for (const int use : loop.uses) {
                around.insert(topology_.uses[static_cast<std::size_t>(use)].edge);
            }
        }
        topology_.faces[static_cast<std::size_t>(face)].loops.clear();
        std::vector<int> sides;
        for (const int e : around) {
            std::vector<int>& uses = edge(e).uses;
            const auto on_face = [&](int use) { return topology_.uses[static_cast<std::size_t>(use)].face == face; };
            uses.erase(std::remove_if(uses.begin(), uses.end(), on_face), uses.end());
            if (is_a_point(e)) {
                unite(edge(e).nodes[0], edge(e).nodes[1]);
            } else {
                sides.push_back(e);
            }
        }
        if (sides.size() == 2) {
            join(sides[0], sides[1]);
        }
    }

    void unite(int a, int b) {
        if (a >= 0 && b >= 0) {
            nodes_.unite(a, b);
        }
    }
    bool same_node(int a, int b) { return a >= 0 && b >= 0 && nodes_.find(a) == nodes_.find(b); }

    double tolerance(int e) const {
        return 2.0 * std::max(topology_.edges[static_cast<std::size_t>(e)].tolerance, Precision::Confusion());
    }
    EdgeEvaluator curve(int e) { return EdgeEvaluator(live_.edges[static_cast<std::size_t>(e)], edge(e)); }
    double parameter(int e, double share) { return edge(e).t0 + share * (edge(e).t1 - edge(e).t0); }

    bool is_a_point(int e) {
        if (edge(e).degenerate) {
            return true;
        }
        const EdgeEvaluator along = curve(e);
        const Vec3 start = along.point(edge(e).t0).point;
        for (int i = 1; i <= kSamples; ++i) {
            if ((along.point(parameter(e, double(i) / kSamples)).point - start).norm() > tolerance(e)) {
                return false;
            }
        }
        return true;
    }

    /// Whether t grows the same way on both edges; none where the edges do not coincide.
    std::optional<bool> run_alike(int a, int b) {
        const EdgeEvaluator first = curve(a);
        const EdgeEvaluator second = curve(b);
        double before = 0.0;
        double after = 0.0;
        for (int i = 0; i <= kSamples; ++i) {
            const Answer there = first.point(parameter(a, double(i) / kSamples));
            const Answer here = second.nearest(there.point, parameter(b, 0.5), edge(b).t0, edge(b).t1);
            if (!there.found() || !here.found() || here.distance > tolerance(a) + tolerance(b)) {
                return std::nullopt;
            }
            before = i == 1 ? here.t : before;
            after = i == kSamples - 1 ? here.t : after;
        }
        return after > before;
    }

    /// Makes all uses of `b` uses of `a`.
    void join(int a, int b) {
        const std::optional<bool> alike = run_alike(a, b);
        if (!alike || !run_alike(b, a)) {
            return;
        }
        unite(edge(a).nodes[0], edge(b).nodes[*alike ? 0 : 1]);
        unite(edge(a).nodes[1], edge(b).nodes[*alike ? 1 : 0]);
        for (const int u : edge(b).uses) {
            EdgeUse& use = topology_.uses[static_cast<std::size_t>(u)];
            PCurve& on_face = live_.uses[static_cast<std::size_t>(u)];
            use.edge = a;
            on_face.of_neighbour = true;
            if (!*alike) {
                use.forward = !use.forward;
                std::swap(on_face.first, on_face.last);
            }
            edge(a).uses.push_back(u);
        }
        edge(a).tolerance = std::max(edge(a).tolerance, edge(b).tolerance);
        edge(b).uses.clear();
    }

    void join_folded_edges() {
        const int all = static_cast<int>(topology_.edges.size());
        const int own = static_cast<int>(topology_.own_count(1));
        for (int b = own; b < all; ++b) {
            const Entity whole = topology_.of_shape({1, b});
            for (const int a : topology_.pieces_of(whole)) {
                const bool halves = whole.dimension == 1 && a != b && edge(a).uses.size() == 1 &&
                                    edge(b).uses.size() == 1 && share_a_node(a, b);
                if (halves && !is_a_point(a) && !is_a_point(b)) {
                    join(a, b);
                }
            }
        }
    }

    bool share_a_node(int a, int b) {
        for (const int n : edge(a).nodes) {
            if (same_node(n, edge(b).nodes[0]) || same_node(n, edge(b).nodes[1])) {
                return true;
            }
        }
        return false;
    }

    const OrderedShape& shape_;
    Topology& topology_;
    ShapeMap& live_;
    const Progress* progress_;
    DisjointSets<int> nodes_;
};

}  // namespace

void sew_collapsed_pieces(const OrderedShape& shape, Topology& topology, ShapeMap& live, const Progress* progress) {
    CollapsedPieces(shape, topology, live, progress).run();
}

}  // namespace mq::geometry

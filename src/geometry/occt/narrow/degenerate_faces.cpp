// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/degenerate_faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/message.h"
#include "geometry/detail.h"
#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/edge_evaluator.h"
#include "geometry/occt/narrow/edge_joining.h"

namespace mq::geometry {

namespace {

class DegenerateFaces : EdgeJoining {
  public:
    DegenerateFaces(const OrderedShape& shape, Topology& topology, ShapeMap& live, const Progress* progress)
        : EdgeJoining(topology, live), shape_(shape), progress_(progress) {}

    void run() {
        find_thin_faces();
        for (int f = 0; f < static_cast<int>(topology_.faces.size()); ++f) {
            check_cancelled(progress_);
            if (topology_.faces[static_cast<std::size_t>(f)].no_area && is_piece(f)) {
                const std::vector<int> sides = detach(f);
                if (sides.size() == 2) {
                    join(sides[0], sides[1]);
                }
            } else {
                collapse_if_sliver(f);
            }
        }
        join_folded_edges();
        rename_nodes();
    }

  private:
    bool is_piece(int face) const { return shape_.is_cut(topology_.of_shape({2, face}).index); }

    using Pair = std::array<int, 2>;

    /// The edges around a face: pairs that run along each other, and the edges between the ends of the pairs.
    struct Sliver {
        std::vector<int> uses;    // both sides, around the face
        std::vector<Pair> pairs;  // uses that lie across from each other
        std::vector<int> ends;    // edges shorter than the detail, and points
    };

    /// Finds the faces that are thinner than the detail and leave corners at their ends, or other thin faces.
    void find_thin_faces() {
        if (!(topology_.detail > 0.0)) {
            return;
        }
        std::map<int, Sliver> thin;
        for (int f = 0; f < static_cast<int>(topology_.faces.size()); ++f) {
            check_cancelled(progress_);
            Sliver sliver = sides_of(f);
            const bool in_pairs =
                has_sides(sliver) && find_pairs(f, sliver, std::max(own_width(sliver), topology_.detail));
            if ((in_pairs || find_pairs_of_pieces(f, sliver)) && neighbours_open(sliver)) {
                thin_.insert(f);
                thin.emplace(f, std::move(sliver));
            }
        }
        for (std::size_t before = thin_.size() + 1; thin_.size() < before;) {
            before = thin_.size();
            for (const auto& [f, sliver] : thin) {
                if (thin_.count(f) > 0 && !ends_leave_corners(sliver)) {
                    thin_.erase(f);
                }
            }
        }
    }

    /// Whether the edges around a face are sides: all between two nodes, or the two around a ring.
    bool has_sides(const Sliver& sliver) const {
        const auto sides =
            std::count_if(sliver.uses.begin(), sliver.uses.end(), [&](int use) { return is_side(edge_of(use)); });
        const auto ring = [&](int use) {
            const Edge& data = edge(edge_of(use));
            return !data.degenerate && data.uses.size() == 2 && data.nodes[0] >= 0 && data.nodes[0] == data.nodes[1];
        };
        const std::size_t n = sliver.uses.size();
        return (n > 0 && n % 2 == 0 && static_cast<std::size_t>(sides) == n) ||
               (n == 2 && std::all_of(sliver.uses.begin(), sliver.uses.end(), ring));
    }

    /// A place at which an edge is divided, at a node across.
    struct Division {
        int edge;
        double t;
        int node;
    };

    /// A piece of an edge, on a way around a face.
    struct Stretch {
        int edge;
        double from;
        double to;
    };

    /// Sets the pairs of uses whose edges have pieces across from each other, if all of the face lies between these.
    bool find_pairs_of_pieces(int face, Sliver& sliver) {
        for (std::size_t tip = 0; tip < sliver.uses.size(); ++tip) {
            if (!divisions_from(sliver, tip).empty()) {
                return is_plane(face) || lies_along(face, sliver, topology_.detail);
            }
        }
        return false;
    }

    /// Divides the edges around a face at the nodes across from them, where its border runs along itself between two
    /// ends, so that they lie in pairs.
    void divide_across(int face) {
        Sliver sliver = sides_of(face);
        for (std::size_t tip = 0; tip < sliver.uses.size(); ++tip) {
            std::vector<Division> divisions = divisions_from(sliver, tip);
            if (divisions.empty()) {
                continue;
            }
            // The first piece of an edge keeps its number.
            std::sort(divisions.begin(), divisions.end(),
                      [](const Division& a, const Division& b) { return a.t > b.t; });
            for (const Division& division : divisions) {
                divide(division.edge, division.t, division.node);
            }
            return;
        }
    }

    /// The divisions that make pairs of all edges, on both ways around the face from the start of a use, and the uses
    /// that are pairs then; no divisions: that is not possible, or there are none to make.
    std::vector<Division> divisions_from(Sliver& sliver, std::size_t tip) {
        const std::size_t n = sliver.uses.size();
        std::vector<Division> divisions;
        sliver.pairs.clear();
        std::array<std::size_t, 2> passed{0, 0};    // ahead and back
        std::array<std::optional<double>, 2> from;  // where what is left of the present edges begins
        while (passed[0] + passed[1] + 1 < n) {
            const Pair uses{sliver.uses[(tip + passed[0]) % n], sliver.uses[(tip + n - 1 - passed[1]) % n]};
            if (!is_side(edge_of(uses[0])) || !is_side(edge_of(uses[1]))) {
                return {};
            }
            std::array<Stretch, 2> pieces{stretch(uses[0], true, from[0]), stretch(uses[1], false, from[1])};
            const Pair ends{end_of(uses[0], true), end_of(uses[1], false)};
            sliver.pairs.push_back(uses);
            if (meet(ends[0], ends[1], sliver.ends)) {
                from = {};
                ++passed[0];
                ++passed[1];
            } else {
                const std::optional<double> on_second = foot_inside(ends[0], pieces[1]);
                const std::optional<double> on_first = on_second ? std::nullopt : foot_inside(ends[1], pieces[0]);
                if (!on_second && !on_first) {
                    return {};
                }
                const std::size_t shorter = on_second ? 0 : 1;
                Stretch& longer = pieces[1 - shorter];
                longer.to = on_second ? *on_second : *on_first;
                divisions.push_back({longer.edge, longer.to, ends[shorter]});
                from[shorter] = std::nullopt;
                from[1 - shorter] = longer.to;
                ++passed[shorter];
            }
            if (!lies_along(pieces[0], pieces[1]) || !lies_along(pieces[1], pieces[0])) {
                return {};
            }
        }
        return passed[0] + passed[1] == n ? divisions : std::vector<Division>();
    }

    /// What is left of the edge of a use on the way around its face, or back.
    Stretch stretch(int use, bool ahead, std::optional<double> from) const {
        const EdgeUse& data = topology_.uses[static_cast<std::size_t>(use)];
        const Edge& whole = edge(data.edge);
        const bool ascending = data.forward == ahead;
        return {data.edge, from.value_or(ascending ? whole.t0 : whole.t1), ascending ? whole.t1 : whole.t0};
    }

    /// Whether a piece of an edge lies within the detail of another one.
    bool lies_along(const Stretch& piece, const Stretch& other) const {
        for (int i = 1; i < kSamples; ++i) {
            const Vec3 p = curve(piece.edge).point(piece.from + (piece.to - piece.from) * i / kSamples).point;
            const Answer foot = nearest_on(other.edge, p, topology_.detail,
                                           {std::min(other.from, other.to), std::max(other.from, other.to)});
            if (!foot.found() || foot.distance > topology_.detail) {
                return false;
            }
        }
        return true;
    }

    /// The node at the end of a use on the way around its face, or back.
    int end_of(int use, bool ahead) const {
        const EdgeUse& data = topology_.uses[static_cast<std::size_t>(use)];
        return edge(data.edge).nodes[data.forward == ahead ? 1 : 0];
    }

    /// The parameter of a piece of an edge beside a node that is closer to it than the detail, and not so close to its
    /// ends.
    std::optional<double> foot_inside(int node, const Stretch& piece) const {
        const Vec3& point = topology_.nodes[static_cast<std::size_t>(node)].point;
        const Answer foot = nearest_on(piece.edge, point, topology_.detail,
                                       {std::min(piece.from, piece.to), std::max(piece.from, piece.to)});
        if (!foot.found() || foot.distance >= topology_.detail) {
            return std::nullopt;
        }
        const auto near = [&](double t) {
            return (curve(piece.edge).point(t).point - foot.point).norm() < topology_.detail;
        };
        return near(piece.from) || near(piece.to) ? std::nullopt : std::optional(foot.t);
    }

    void collapse_if_sliver(int face) {
        const bool thin = thin_.count(face) > 0;
        if (thin) {
            divide_across(face);
        }
        Face& data = topology_.faces[static_cast<std::size_t>(face)];
        Sliver sliver = sides_of(face);
        if (!has_sides(sliver)) {
            return;
        }
        const double own = own_width(sliver);
        if ((thin || sliver.ends.empty()) && find_pairs(face, sliver, own)) {
            topology_.faults.push_back(topology_.name_of({2, face}) +
                                       ": is no wider than the tolerance of its edges, which count as one");
        } else if (thin && find_pairs(face, sliver, topology_.detail)) {
            topology_.faults.push_back(topology_.name_of({2, face}) + ": is thinner than " +
                                       in_digits(topology_.detail, 4) +
                                       " mm, which does not show at what is asked for: its edges count as one");
        } else {
            return;
        }
        data.no_area = true;
        std::vector<Pair> edges;
        for (const Pair& pair : sliver.pairs) {
            edges.push_back({edge_of(pair[0]), edge_of(pair[1])});
        }
        detach(face);
        for (const Pair& pair : edges) {
            join(pair[0], pair[1], std::max(own, topology_.detail));
        }
    }

    /// The two smallest tolerances of a sliver's sides together, mm.
    double own_width(const Sliver& sliver) const {
        std::vector<double> tolerances;
        for (const int use : sliver.uses) {
            tolerances.push_back(tolerance(edge_of(use)));
        }
        std::sort(tolerances.begin(), tolerances.end());
        return tolerances[0] + tolerances[1];
    }

    Sliver sides_of(int face) {
        Sliver result;
        const Face& data = topology_.faces[static_cast<std::size_t>(face)];
        // Edges around a sliver at most: the cost grows with its square.
        constexpr std::size_t kMostSliverEdges = 64;
        if (data.loops.size() != 1 || data.loops.front().uses.size() > kMostSliverEdges) {
            return result;
        }
        for (const int use : data.loops.front().uses) {
            if (edge(edge_of(use)).degenerate || is_short(edge_of(use))) {
                result.ends.push_back(edge_of(use));
            } else {
                result.uses.push_back(use);
            }
        }
        return result;
    }

    /// Sets the pairs, if there is a place from which the border runs along itself in both directions, and all of the
    /// face lies within this distance of it.
    bool find_pairs(int face, Sliver& sliver, double distance) {
        const std::size_t n = sliver.uses.size();
        for (std::size_t tip = 0; tip < n / 2; ++tip) {
            sliver.pairs.clear();
            for (std::size_t k = 0; k < n / 2; ++k) {
                const Pair pair{sliver.uses[(tip + k) % n], sliver.uses[(tip + n - 1 - k) % n]};
                if (!coincide(edge_of(pair[0]), edge_of(pair[1]), sliver.ends, distance)) {
                    break;
                }
                sliver.pairs.push_back(pair);
            }
            if (sliver.pairs.size() == n / 2) {
                return is_plane(face) || lies_along(face, sliver, distance);
            }
        }
        return false;
    }

    bool is_plane(int face) const {
        return std::string(topology_.faces[static_cast<std::size_t>(face)].surface) == "plane";
    }

    /// Whether two edges lie within a distance of each other, mm, between the same ends.
    bool coincide(int a, int b, const std::vector<int>& between, double distance) {
        const std::optional<Alignment> along = a != b ? alignment(a, b, distance) : std::nullopt;
        if (!along || !alignment(b, a, distance)) {
            return false;
        }
        return meet(edge(a).nodes[0], edge(b).nodes[along->same_way ? 0 : 1], between) &&
               meet(edge(a).nodes[1], edge(b).nodes[along->same_way ? 1 : 0], between);
    }

    /// Whether two nodes are one, joined by one of the edges, or closer to each other than the detail.
    bool meet(int a, int b, const std::vector<int>& edges) {
        const auto point = [&](int n) { return topology_.nodes[static_cast<std::size_t>(n)].point; };
        return same_node(a, b) || (point(a) - point(b)).norm() < topology_.detail ||
               std::any_of(edges.begin(), edges.end(), [&](int e) {
                   const auto& nodes = edge(e).nodes;
                   return (same_node(a, nodes[0]) && same_node(b, nodes[1])) ||
                          (same_node(a, nodes[1]) && same_node(b, nodes[0]));
               });
    }

    /// Whether the faces on the other sides of a sliver's edges do not lie on each other, as those of a thin plate.
    bool neighbours_open(const Sliver& sliver) {
        return std::all_of(sliver.pairs.begin(), sliver.pairs.end(),
                           [&](const Pair& pair) { return others_open(pair[0], pair[1]); });
    }

    /// Whether the faces beyond the ends of a sliver keep a corner there, where they lose an edge, or are thin, too.
    bool ends_leave_corners(const Sliver& sliver) {
        return std::all_of(sliver.ends.begin(), sliver.ends.end(), [&](int e) {
            return std::all_of(edge(e).uses.begin(), edge(e).uses.end(), [&](int use) {
                return thin_.count(topology_.uses[static_cast<std::size_t>(use)].face) > 0 || leaves_corner(use);
            });
        });
    }

    bool lies_along(int face, const Sliver& sliver, double within) {
        const Face& data = topology_.faces[static_cast<std::size_t>(face)];
        const BRepAdaptor_Surface surface(live_.faces[static_cast<std::size_t>(face)], Standard_False);
        for (int i = 0; i <= kSamples; ++i) {
            for (int k = 0; k <= kSamples; ++k) {
                const Vec3 p = to_vec(surface.Value(data.low[0] + (data.high[0] - data.low[0]) * i / kSamples,
                                                    data.low[1] + (data.high[1] - data.low[1]) * k / kSamples));
                if (std::none_of(sliver.pairs.begin(), sliver.pairs.end(), [&](const Pair& pair) {
                        const int e = edge_of(pair[0]);
                        const Answer foot = nearest_on(e, p, within);
                        return foot.found() && foot.distance <= within;
                    })) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Removes a face, and merges edges of it that are points.
    /// @return its other edges
    std::vector<int> detach(int face) {
        std::set<int> around;
        for (const Loop& loop : topology_.faces[static_cast<std::size_t>(face)].loops) {
            for (const int use : loop.uses) {
                around.insert(edge_of(use));
            }
        }
        topology_.faces[static_cast<std::size_t>(face)].loops.clear();
        std::vector<int> sides;
        for (const int e : around) {
            std::vector<int>& uses = edge(e).uses;
            const auto on_face = [&](int use) { return topology_.uses[static_cast<std::size_t>(use)].face == face; };
            uses.erase(std::remove_if(uses.begin(), uses.end(), on_face), uses.end());
            if (is_short(e)) {
                edge(e).degenerate = true;
            }
            if (is_a_point(e)) {
                unite(edge(e).nodes[0], edge(e).nodes[1]);
            } else {
                sides.push_back(e);
            }
        }
        return sides;
    }

    bool is_a_point(int e) {
        if (edge(e).degenerate) {
            return true;
        }
        const EdgeEvaluator& along = curve(e);
        const Vec3 start = along.point(edge(e).t0).point;
        for (int i = 1; i <= kSamples; ++i) {
            if ((along.point(parameter(e, double(i) / kSamples)).point - start).norm() > tolerance(e)) {
                return false;
            }
        }
        return true;
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
    const Progress* progress_;
    std::set<int> thin_;
};

}  // namespace

void remove_degenerate_faces(const OrderedShape& shape, Topology& topology, ShapeMap& live, const Progress* progress) {
    DegenerateFaces(shape, topology, live, progress).run();
}

}  // namespace mq::geometry

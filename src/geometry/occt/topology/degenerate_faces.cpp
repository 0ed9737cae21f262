// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/degenerate_faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <algorithm>
#include <cmath>
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
#include "geometry/occt/topology/edge_joining.h"

namespace mq::geometry {

namespace {

class CollapsedPieces : EdgeJoining {
  public:
    CollapsedPieces(const OrderedShape& shape, Topology& topology, ShapeMap& live, const Progress* progress)
        : EdgeJoining(topology, live), shape_(shape), progress_(progress) {}

    void run() {
        for (int f = 0; f < static_cast<int>(topology_.faces.size()); ++f) {
            check_cancelled(progress_);
            if (topology_.faces[static_cast<std::size_t>(f)].no_area && is_piece(f)) {
                take_out(f);
            } else {
                collapse_if_sliver(f);
            }
        }
        join_folded_edges();
        rename_nodes();
    }

  private:
    bool is_piece(int face) const { return shape_.is_cut(topology_.of_shape({2, face}).index); }

    /// Two edges that bound a face, and those between their ends.
    struct Sliver {
        std::vector<int> uses;   // the uses of both sides
        std::vector<int> edges;  // both sides
        std::vector<int> ends;   // edges shorter than the detail
    };

    void collapse_if_sliver(int face) {
        Face& data = topology_.faces[static_cast<std::size_t>(face)];
        const Sliver sliver = sides_of(face);
        if (sliver.edges.size() != 2 || sliver.edges[0] == sliver.edges[1] || !is_side(sliver.edges[0]) ||
            !is_side(sliver.edges[1])) {
            return;
        }
        const double own = tolerance(sliver.edges[0]) + tolerance(sliver.edges[1]);
        if (sliver.ends.empty() && is_within(face, sliver, own)) {
            topology_.faults.push_back(topology_.name_of({2, face}) +
                                       ": is no wider than the tolerance of its edges, which count as one");
        } else if (topology_.detail > own && is_within(face, sliver, topology_.detail) && neighbours_open(sliver) &&
                   ends_leave_corners(face, sliver)) {
            topology_.faults.push_back(topology_.name_of({2, face}) + ": is thinner than " +
                                       in_digits(topology_.detail, 4) +
                                       " mm, which does not show at what is asked for: its edges count as one");
        } else {
            return;
        }
        data.no_area = true;
        take_out(face, topology_.detail);
    }

    Sliver sides_of(int face) {
        Sliver result;
        const Face& data = topology_.faces[static_cast<std::size_t>(face)];
        // Edges around a sliver at most: two sides, and three short ones at either end.
        constexpr std::size_t kMost = 8;
        if (data.loops.size() != 1 || data.loops.front().uses.size() > kMost) {
            return result;
        }
        for (const int use : data.loops.front().uses) {
            const int e = topology_.uses[static_cast<std::size_t>(use)].edge;
            if (is_short(e)) {
                result.ends.push_back(e);
            } else {
                result.uses.push_back(use);
                result.edges.push_back(e);
            }
        }
        return result;
    }

    /// Whether both sides run between the same ends, and all of the face lies within this distance of either.
    bool is_within(int face, const Sliver& sliver, double distance) {
        const int a = sliver.edges[0];
        const int b = sliver.edges[1];
        const std::optional<Alignment> along = alignment(a, b, distance);
        if (!along || !alignment(b, a, distance)) {
            return false;
        }
        for (int i = 0; i < 2; ++i) {
            if (!meet(edge(a).nodes[i], edge(b).nodes[along->same_way ? i : 1 - i], sliver.ends)) {
                return false;
            }
        }
        const bool plane = std::string(topology_.faces[static_cast<std::size_t>(face)].surface) == "plane";
        return plane || lies_along(face, a, distance);
    }

    /// Whether two nodes are one, or joined by one of the edges.
    bool meet(int a, int b, const std::vector<int>& edges) {
        return same_node(a, b) || std::any_of(edges.begin(), edges.end(), [&](int e) {
                   const auto& nodes = edge(e).nodes;
                   return (same_node(a, nodes[0]) && same_node(b, nodes[1])) ||
                          (same_node(a, nodes[1]) && same_node(b, nodes[0]));
               });
    }

    /// Whether the faces on the other sides of a sliver's edges do not lie on each other, as those of a thin plate.
    bool neighbours_open(const Sliver& sliver) {
        const std::optional<double> angle = dihedral_angle(opposite_use(sliver.uses[0]), opposite_use(sliver.uses[1]));
        return angle && *angle >= DetailCorners::kLeast;
    }

    /// Whether the faces beyond the ends of a sliver keep a corner there, where they lose an edge.
    bool ends_leave_corners(int face, const Sliver& sliver) {
        return std::all_of(sliver.ends.begin(), sliver.ends.end(), [&](int e) {
            return std::all_of(edge(e).uses.begin(), edge(e).uses.end(), [&](int use) {
                return topology_.uses[static_cast<std::size_t>(use)].face == face || leaves_corner(use);
            });
        });
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

    /// @param within  distance up to which two sides count as one; 0: twice their tolerances
    void take_out(int face, double within = 0.0) {
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
            if (is_short(e)) {
                edge(e).degenerate = true;
            }
            if (is_a_point(e)) {
                unite(edge(e).nodes[0], edge(e).nodes[1]);
            } else {
                sides.push_back(e);
            }
        }
        if (sides.size() == 2) {
            join(sides[0], sides[1], within);
        }
    }

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
};

}  // namespace

void sew_collapsed_pieces(const OrderedShape& shape, Topology& topology, ShapeMap& live, const Progress* progress) {
    CollapsedPieces(shape, topology, live, progress).run();
}

}  // namespace mq::geometry

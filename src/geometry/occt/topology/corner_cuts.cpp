// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/corner_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/angle.h"
#include "base/message.h"
#include "geometry/detail.h"
#include "geometry/occt/topology/edge_joining.h"

namespace mq::geometry {

namespace {

class CornerCuts : EdgeJoining {
  public:
    using EdgeJoining::EdgeJoining;

    /// The place at which the edges of two neighbouring uses of a loop are the detail apart.
    struct Cut {
        int face;
        std::array<int, 2> edges;     // the first one ends in the corner, the second one begins there
        std::array<bool, 2> forward;  // as their uses
        std::array<double, 2> t;
        Vec3 middle;
        double half_width;  // mm
        double depth;       // from the corner, mm
    };

    /// The cuts, at most one at each end of an edge: the deepest ones, as their corners are the narrowest.
    std::vector<Cut> find(const Progress* progress) const {
        std::vector<Cut> cuts;
        for (const Face& face : topology_.faces) {
            check_cancelled(progress);
            for (const Loop& loop : face.loops) {
                for (std::size_t i = 0; i < loop.uses.size() && loop.uses.size() > 1; ++i) {
                    if (const auto cut = cut_between(loop.uses[i], loop.uses[(i + 1) % loop.uses.size()])) {
                        cuts.push_back(*cut);
                    }
                }
            }
        }
        std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.depth > b.depth; });
        std::map<std::array<int, 2>, double> taken;  // the depth by edge and end
        const auto conflicts = [&](const Cut& cut) {
            std::array<std::array<int, 2>, 2> ends;
            for (std::size_t k = 0; k < 2; ++k) {
                ends[k] = {cut.edges[k], cut.forward[k] == (k == 0) ? 1 : 0};
                const auto [e, end] = ends[k];
                const auto opposite = taken.find({e, 1 - end});
                if (taken.count(ends[k]) > 0 ||
                    (opposite != taken.end() && opposite->second + cut.depth + topology_.detail > length(e))) {
                    return true;
                }
            }
            taken.insert({{ends[0], cut.depth}, {ends[1], cut.depth}});
            return false;
        };
        cuts.erase(std::remove_if(cuts.begin(), cuts.end(), conflicts), cuts.end());
        return cuts;
    }

    void apply(const Cut& cut) {
        const int node = add_node(cut.middle, cut.half_width, {1, cut.edges[0]});
        std::array<int, 2> tips{};
        for (std::size_t k = 0; k < 2; ++k) {
            const bool tip_is_last = cut.forward[k] == (k == 0);
            const int e = piece_of(cut, k);
            const int second = divide(e, cut.t[k], node);
            tips[k] = tip_is_last ? second : e;
        }
        const double within = 2.0 * topology_.detail;
        if (!alignment(tips[0], tips[1], within) || !alignment(tips[1], tips[0], within)) {
            return;  // apart between the corner and the cut: both edges have a node more
        }
        topology_.cut_corners.push_back(node);
        topology_.faults.push_back(topology_.name_of({2, cut.face}) + ": its narrow corner between " +
                                   topology_.name_of({1, tips[0]}) + " and " + topology_.name_of({1, tips[1]}) +
                                   " is cut off where it is " + in_digits(2.0 * cut.half_width, 4) + " mm wide");
        for (const int tip : tips) {
            const int use = use_on(tip, cut.face);
            for (Loop& loop : topology_.faces[static_cast<std::size_t>(cut.face)].loops) {
                drop(loop, use);
            }
        }
        join(tips[0], tips[1], within);
    }

    void rename() { rename_nodes(); }

  private:
    /// Whether the edge of a use was joined with others, whose parameters differ.
    bool is_joined(int use) const {
        const std::vector<int>& uses = edge(edge_of(use)).uses;
        return std::any_of(uses.begin(), uses.end(),
                           [&](int other) { return live_.uses[static_cast<std::size_t>(other)].of_neighbour; });
    }

    /// Whether the face on the other side of a use has a pole in this node: its border would leave the pole.
    bool pole_beside(int use, int node) const {
        const Face& face = topology_.faces[static_cast<std::size_t>(use_of(opposite_use(use)).face)];
        return std::any_of(face.loops.begin(), face.loops.end(), [&](const Loop& loop) {
            return std::any_of(loop.uses.begin(), loop.uses.end(), [&](int other) {
                return edge(edge_of(other)).degenerate && edge(edge_of(other)).nodes[0] == node;
            });
        });
    }

    /// The point of the edge of a use at this distance from its end (mm), or from its start.
    Answer point_at(int use, bool from_end, double distance) const {
        const Edge& whole = edge(edge_of(use));
        const bool descending = use_of(use).forward == from_end;
        return curve(edge_of(use))
            .at_distance(descending ? whole.t1 : whole.t0, descending ? whole.t0 : whole.t1, distance);
    }

    /// The largest depth that leaves enough of an edge for pieces that open from the cut on.
    double deepest(int e) const {
        constexpr double kRest = 4.0;  // details
        return length(e) - kRest * topology_.detail;
    }

    /// The distance between the edges of two uses at a distance (mm) from their common corner.
    std::optional<double> width(int first, int second, double distance) const {
        const Answer a = point_at(first, true, distance);
        const Answer b = point_at(second, false, distance);
        return a.found() && b.found() ? std::optional<double>((a.point - b.point).norm()) : std::nullopt;
    }

    /// The least distance from their corner at which the edges of two uses are the detail apart, mm. None: they enclose
    /// more than the angle, or do not open.
    std::optional<double> depth_of(int first, int second) const {
        const auto narrow = [&](double distance) {
            const std::optional<double> here = width(first, second, distance);
            return here && *here < topology_.detail;
        };
        const double most = std::min(deepest(edge_of(first)), deepest(edge_of(second)));
        // Edges that meet at this angle are a detail apart there.
        if (!(most > 0.0) || !narrow(topology_.detail / (2.0 * std::sin(0.5 * DetailCorners::kLeastAngle)))) {
            return std::nullopt;
        }
        constexpr int kDepthSteps = 16;  // the edges can meet again at their other ends
        int step = 1;
        while (step <= kDepthSteps && narrow(most * step / kDepthSteps)) {
            ++step;
        }
        if (step > kDepthSteps) {
            return std::nullopt;
        }
        double low = most * (step - 1) / kDepthSteps;
        double high = most * step / kDepthSteps;
        constexpr int kHalvings = 50;
        for (int n = 0; n < kHalvings && high - low > 1e-6 * high; ++n) {
            const double middle = 0.5 * (low + high);
            (narrow(middle) ? low : high) = middle;
        }
        return low;
    }

    std::optional<Cut> cut_between(int first, int second) const {
        if (first == second || !parts_two_faces(first) || !parts_two_faces(second) || is_joined(first) ||
            is_joined(second) || edge_of(first) == edge_of(second) || is_short(edge_of(first)) ||
            is_short(edge_of(second))) {
            return std::nullopt;
        }
        const int corner = edge(edge_of(first)).nodes[use_of(first).forward ? 1 : 0];
        if (pole_beside(first, corner) || pole_beside(second, corner)) {
            return std::nullopt;
        }
        const std::optional<double> depth = depth_of(first, second);
        if (!depth || !stays_open(first, second, *depth)) {
            return std::nullopt;
        }
        const Answer a = point_at(first, true, *depth);
        const Answer b = point_at(second, false, *depth);
        if (!a.found() || !b.found()) {
            return std::nullopt;
        }
        return Cut{use_of(first).face,
                   {edge_of(first), edge_of(second)},
                   {use_of(first).forward, use_of(second).forward},
                   {a.t, b.t},
                   0.5 * (a.point + b.point),
                   0.5 * (a.point - b.point).norm(),
                   *depth};
    }

    /// Whether the faces on the other sides of the edges do not lie on each other half-way from the corner to the cut.
    bool stays_open(int first, int second, double distance) const {
        const Answer a = point_at(first, true, 0.5 * distance);
        const Answer b = point_at(second, false, 0.5 * distance);
        const auto into_first = a.found() ? conormal(opposite_use(first), a.t) : std::nullopt;
        const auto into_second = b.found() ? conormal(opposite_use(second), b.t) : std::nullopt;
        return into_first && into_second && angle_between(*into_first, *into_second) >= DetailCorners::kLeastAngle;
    }

    /// The piece of an edge that is to be divided: the edge may have been divided at its other end.
    int piece_of(const Cut& cut, std::size_t k) const {
        for (const Loop& loop : topology_.faces[static_cast<std::size_t>(cut.face)].loops) {
            for (const int use : loop.uses) {
                const Edge& piece = edge(edge_of(use));
                if (topology_.of_shape({1, edge_of(use)}) == topology_.of_shape({1, cut.edges[k]}) &&
                    cut.t[k] > piece.t0 && cut.t[k] < piece.t1) {
                    return edge_of(use);
                }
            }
        }
        return cut.edges[k];
    }
};

}  // namespace

void cut_narrow_corners(Topology& topology, ShapeMap& live, const Progress* progress) {
    if (!(topology.detail > 0.0)) {
        return;
    }
    CornerCuts corners(topology, live);
    for (const CornerCuts::Cut& cut : corners.find(progress)) {
        corners.apply(cut);
    }
    corners.rename();
}

}  // namespace mq::geometry

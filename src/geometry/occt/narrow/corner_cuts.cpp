// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/corner_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/angle.h"
#include "base/message.h"
#include "base/segment_distance.h"
#include "geometry/detail.h"
#include "geometry/occt/narrow/edge_joining.h"

namespace mq::geometry {

namespace {

class NarrowCorners : EdgeJoining {
  public:
    using EdgeJoining::EdgeJoining;

    /// The place at which the edges of two uses that meet in a corner of a face are the detail apart.
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
    std::vector<Cut> find(CornerCuts kinds, const Progress* progress) const {
        std::vector<Cut> cuts;
        for (const Face& face : topology_.faces) {
            check_cancelled(progress);
            for (const auto& [corner, ends] : ends_at_nodes(face)) {
                for (const int first : ends.arriving) {
                    for (const int second : ends.leaving) {
                        if (kinds == CornerCuts::All || at_pinch(ends, first, second) || is_sharp(first, second)) {
                            if (const auto cut = cut_between(first, second, ends)) {
                                cuts.push_back(*cut);
                            }
                        }
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
            const int e = piece_at(cut.face, cut.edges[k], cut.t[k]);
            const int second = divide(e, cut.t[k], node);
            tips[k] = tip_is_last ? second : e;
        }
        const double within = kWithin * topology_.detail;
        if (!alignment(tips[0], tips[1], within) || !alignment(tips[1], tips[0], within)) {
            return;  // apart between the corner and the cut: both edges have a node more
        }
        topology_.cut_corners.push_back(node);
        topology_.faults.push_back(topology_.name_of({2, cut.face}) + ": its narrow corner between " +
                                   topology_.name_of({1, tips[0]}) + " and " + topology_.name_of({1, tips[1]}) +
                                   " is cut off where it is " + in_digits(2.0 * cut.half_width, 4) + " mm wide");
        take_out(topology_.faces[static_cast<std::size_t>(cut.face)].loops, use_at(cut, tips, 0), use_at(cut, tips, 1));
        join(tips[0], tips[1], within);
    }

    void rename() { rename_nodes(); }

  private:
    static constexpr double kWithin = 2.0;  // details: the largest distance of edges that are joined

    /// The uses on a face that end in a node, and those that begin there.
    struct Ends {
        std::vector<int> arriving;
        std::vector<int> leaving;
    };

    std::map<int, Ends> ends_at_nodes(const Face& face) const {
        std::map<int, Ends> ends;
        for (const Loop& loop : face.loops) {
            for (const int use : loop.uses) {
                const std::array<int, 2>& nodes = edge(edge_of(use)).nodes;
                ends[nodes[use_of(use).forward ? 1 : 0]].arriving.push_back(use);
                ends[nodes[use_of(use).forward ? 0 : 1]].leaving.push_back(use);
            }
        }
        return ends;
    }

    /// The innermost piece of an edge, up to the corner where its use ends, or from the one where it starts: the edge
    /// itself, or a half, a quarter, ... of it, until the edge is nowhere farther from it than asked for. @return  mm
    double innermost_piece(int use, bool from_end) const {
        constexpr int kMaxHalvings = 20;
        const int corner = edge(edge_of(use)).nodes[use_of(use).forward == from_end ? 1 : 0];
        const Vec3& start = topology_.nodes[static_cast<std::size_t>(corner)].point;
        const double asked = topology_.detail / kDetailOfWhatIsAsked;
        double piece = length(edge_of(use));
        for (int n = 0; n < kMaxHalvings; ++n) {
            const Answer middle = point_at(use, from_end, 0.5 * piece);
            const Answer end = point_at(use, from_end, piece);
            if (middle.found() && end.found() && distance_to_segment(middle.point, start, end.point) <= asked) {
                break;
            }
            piece *= 0.5;
        }
        return piece;
    }

    /// Whether the innermost pieces in a corner are too long beside its width at their ends: no graded fans beside them
    /// are found then. For pieces twice as long InfeasibleCorner (triangulate) has the proof that there are none.
    bool is_sharp(int first, int second) const {
        constexpr double kLongest = 150.0;  // widths, 35 of 69 times the next piece at 25 degrees
        if (!divides_faces(first) || !divides_faces(second)) {
            return false;
        }
        const double piece = std::min(innermost_piece(first, true), innermost_piece(second, false));
        const std::optional<double> across = width(first, second, piece);
        return across && piece > kLongest * *across;
    }

    /// Whether two points are across the face from each other: each lies on the inner side of the use of the other one.
    bool face_between(int first, const Answer& a, int second, const Answer& b) const {
        const auto from_first = conormal(first, a.t);
        const auto from_second = conormal(second, b.t);
        const Vec3 between = b.point - a.point;
        return from_first && from_second && between.dot(*from_first) > 0.0 && between.dot(*from_second) < 0.0;
    }

    /// Whether the edge of another use at a corner lies between two points at this distance from it (mm).
    bool edge_between(const Ends& ends, int first, const Answer& a, int second, const Answer& b,
                      double distance) const {
        const double apart = (a.point - b.point).norm();
        const auto lies_between = [&](int use, bool from_end) {
            const Answer there = point_at(use, from_end, distance);
            return use != first && use != second && there.found() && (there.point - a.point).norm() < apart &&
                   (there.point - b.point).norm() < apart;
        };
        return std::any_of(ends.arriving.begin(), ends.arriving.end(),
                           [&](int use) { return lies_between(use, true); }) ||
               std::any_of(ends.leaving.begin(), ends.leaving.end(), [&](int use) { return lies_between(use, false); });
    }

    bool of_seam(int use) const {
        return edge(edge_of(use)).uses.size() == 2 && use_of(opposite_use(use)).face == use_of(use).face;
    }

    /// Whether the border touches itself in the corner of two uses, or one of them is of a seam.
    bool at_pinch(const Ends& ends, int first, int second) const {
        return ends.arriving.size() > 1 || of_seam(first) || of_seam(second);
    }

    /// Takes the two uses at a corner out of the loops of their face, of which the one ends and the other begins there:
    /// what comes before the one is followed by what comes after the other. A loop that touches itself in the corner
    /// becomes two, and two that touch each other become one.
    void take_out(std::vector<Loop>& loops, int last, int first) {
        const auto loop_of = [&](int use) {
            return std::find_if(loops.begin(), loops.end(), [&](const Loop& loop) {
                return std::find(loop.uses.begin(), loop.uses.end(), use) != loop.uses.end();
            });
        };
        const auto begin_after = [](Loop& loop, int use) {
            const auto at = std::find(loop.uses.begin(), loop.uses.end(), use);
            std::rotate(loop.uses.begin(), at + 1, loop.uses.end());
        };
        const auto ending = loop_of(last);
        const auto beginning = loop_of(first);
        begin_after(*ending, last);  // `last` is its last one now
        if (ending == beginning) {
            const auto at = std::find(ending->uses.begin(), ending->uses.end(), first);
            Loop rest{{ending->uses.begin(), at}};
            ending->uses.erase(ending->uses.begin(), at);
            if (!rest.uses.empty()) {
                loops.push_back(std::move(rest));
            }
        } else {
            begin_after(*beginning, first);
            ending->uses.insert(ending->uses.end(), beginning->uses.begin(), beginning->uses.end());
            loops.erase(beginning);
        }
        for (Loop& loop : loops) {
            drop(loop, last);
            drop(loop, first);
        }
    }

    /// Whether something lies on the other side of the edge of a use: another face, or the same one at a seam.
    bool divides_faces(int use) const {
        const Edge& whole = edge(edge_of(use));
        return !whole.degenerate && whole.uses.size() == 2 && whole.nodes[0] >= 0 && whole.nodes[1] >= 0;
    }

    /// The use of a tip in the corner: a seam has another one on the same face.
    int use_at(const Cut& cut, const std::array<int, 2>& tips, std::size_t k) const {
        const std::vector<int>& uses = edge(tips[k]).uses;
        return *std::find_if(uses.begin(), uses.end(), [&](int use) {
            return use_of(use).face == cut.face && use_of(use).forward == cut.forward[k];
        });
    }

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

    /// Whether two edges lie along each other between their corner and a distance from it (mm).
    bool stays_narrow(int first, int second, double distance) const {
        for (int i = 1; i < kSamples; ++i) {
            const std::optional<double> here = width(first, second, distance * i / kSamples);
            if (!here || *here > kWithin * topology_.detail) {
                return false;
            }
        }
        return true;
    }

    /// The largest depth that leaves enough of an edge for pieces that open from the cut on.
    double deepest(int e) const {
        constexpr double kRest = 4.0;  // details
        return length(e) - kRest * topology_.detail;
    }

    /// The distance from a corner of DetailCorners::kLeastAngle at which its edges are a detail apart, mm.
    double reach() const { return topology_.detail / (2.0 * std::sin(0.5 * DetailCorners::kLeastAngle)); }

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
        if (!(most > 0.0) || !narrow(reach())) {
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

    std::optional<Cut> cut_between(int first, int second, const Ends& ends) const {
        if (first == second || !divides_faces(first) || !divides_faces(second) || is_joined(first) ||
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
        if (!a.found() || !b.found() || !face_between(first, a, second, b) ||
            edge_between(ends, first, a, second, b, *depth) || !stays_narrow(first, second, *depth)) {
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
        return a.found() && b.found() &&
               angle_of_others(first, a.t, second, b.t) >=
                   (others_meet(first, second) ? DetailCorners::kLeastAngle : DetailCorners::kLeastDihedral);
    }

    /// Whether the faces on the other sides of two uses have an edge in common that leaves their corner: both would get
    /// a triangle between it and the joined piece.
    bool others_meet(int first, int second) const {
        const int corner = edge(edge_of(first)).nodes[use_of(first).forward ? 1 : 0];
        const int face = use_of(opposite_use(first)).face;
        const int other = use_of(opposite_use(second)).face;
        const auto is_common = [&](int use) {
            const Edge& beside = edge(edge_of(use));
            return (beside.nodes[0] == corner || beside.nodes[1] == corner) &&
                   std::any_of(beside.uses.begin(), beside.uses.end(),
                               [&](int opposite) { return use_of(opposite).face == other; });
        };
        const std::vector<Loop>& loops = topology_.faces[static_cast<std::size_t>(face)].loops;
        return face == other || std::any_of(loops.begin(), loops.end(), [&](const Loop& loop) {
                   return std::any_of(loop.uses.begin(), loop.uses.end(), is_common);
               });
    }
};

}  // namespace

void cut_narrow_corners(Topology& topology, ShapeMap& live, CornerCuts kinds, const Progress* progress) {
    if (!(topology.detail > 0.0) || kinds == CornerCuts::None) {
        return;
    }
    topology.corner_cuts = kinds;
    NarrowCorners corners(topology, live);
    for (const NarrowCorners::Cut& cut : corners.find(kinds, progress)) {
        corners.apply(cut);
    }
    corners.rename();
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/loose_faces.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/narrow/edge_joining.h"
#include "geometry/occt/topology/face_orientation.h"

namespace mq::geometry {

namespace {

class LooseFaces : EdgeJoining {
  public:
    LooseFaces(Topology& topology, ShapeMap& live, const Progress* progress)
        : EdgeJoining(topology, live), progress_(progress), loose_(topology.faces.size(), 0) {
        for (const Volume& volume : topology.volumes) {
            for (const Volume::Side& side : volume.sides) {
                loose_[static_cast<std::size_t>(side.face)] = volume.kind == Volume::Kind::Faces ? 1 : 0;
            }
        }
    }

    /// @return the faces that were turned
    std::vector<int> run() {
        join_pairs();
        if (divide_at_ends()) {
            join_pairs();
        }
        if (joined_ > 0) {
            rename_nodes();
            std::array<char, 120> text;
            std::snprintf(text.data(), text.size(),
                          "edges of loose faces were joined in %d pair%s, at most %.2g mm apart", joined_,
                          joined_ == 1 ? "" : "s", largest_);
            topology_.faults.emplace_back(text.data());
        }
        return orient_loose_faces(topology_, live_, loose_, progress_);
    }

  private:
    struct Pair {
        double distance;
        int a;
        int b;
        bool operator<(const Pair& other) const {
            return std::tie(distance, a, b) < std::tie(other.distance, other.a, other.b);
        }
    };
    using Cell = std::array<std::int64_t, 3>;

    void join_pairs() {
        std::vector<Pair> pairs = near_pairs();
        std::sort(pairs.begin(), pairs.end());
        for (const Pair& pair : pairs) {
            check_cancelled(progress_);
            if (is_free(pair.a) && is_free(pair.b) && join(pair.a, pair.b, topology_.detail)) {
                ++joined_;
                largest_ = std::max(largest_, pair.distance);
            }
        }
    }

    int face_of(int e) const { return topology_.uses[static_cast<std::size_t>(edge(e).uses.front())].face; }

    /// Whether an edge bounds exactly one loose face and is longer than the detail: a shorter one counts as a vertex.
    bool is_free(int e) const {
        const Edge& data = edge(e);
        return data.uses.size() == 1 && !data.degenerate && data.nodes[0] >= 0 && data.nodes[1] >= 0 &&
               !topology_.uses[static_cast<std::size_t>(data.uses.front())].internal &&
               loose_[static_cast<std::size_t>(face_of(e))] != 0 &&
               !topology_.faces[static_cast<std::size_t>(face_of(e))].no_area && !is_short(e);
    }

    const Vec3& end_of(int e, int i) const {
        return topology_.nodes[static_cast<std::size_t>(edge(e).nodes[static_cast<std::size_t>(i)])].point;
    }

    Cell cell_of(const Vec3& p) const {
        Cell cell{};
        for (int i = 0; i < 3; ++i) {
            cell[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(p[i] / topology_.detail));
        }
        return cell;
    }

    /// Pairs of free edges that lie along each other and whose faces do not lie on each other there.
    std::vector<Pair> near_pairs() const {
        std::map<Cell, std::vector<int>> by_end;
        std::vector<Pair> result;
        for (int b = 0; b < static_cast<int>(topology_.edges.size()); ++b) {
            check_cancelled(progress_);
            if (!is_free(b)) {
                continue;
            }
            for (const int a : beside(b, by_end)) {
                if (const std::optional<double> distance = distance_along(a, b)) {
                    result.push_back({*distance, a, b});
                }
            }
            by_end[cell_of(end_of(b, 0))].push_back(b);
            by_end[cell_of(end_of(b, 1))].push_back(b);
        }
        return result;
    }

    /// Earlier edges with an end near the first end of this one.
    std::vector<int> beside(int b, const std::map<Cell, std::vector<int>>& by_end) const {
        std::vector<int> found;
        const Cell middle = cell_of(end_of(b, 0));
        for (int k = 0; k < 27; ++k) {
            const auto at = by_end.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
            if (at != by_end.end()) {
                found.insert(found.end(), at->second.begin(), at->second.end());
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    /// The distance of two edges that lie along each other, mm; none for others, and where their faces lie on each
    /// other.
    std::optional<double> distance_along(int a, int b) const {
        const std::optional<Alignment> first = alignment(a, b, topology_.detail);
        const std::optional<Alignment> second = first ? alignment(b, a, topology_.detail) : std::nullopt;
        if (!second) {
            return std::nullopt;
        }
        for (int i = 0; i < 2; ++i) {
            if ((end_of(a, i) - end_of(b, first->same_way ? i : 1 - i)).norm() > topology_.detail) {
                return std::nullopt;
            }
        }
        // Radians: least angle between faces that are joined; copies of a face lie on each other.
        constexpr double kLeastAngle = 2.0 * kDegree;
        const std::optional<double> angle = dihedral_angle(edge(a).uses.front(), edge(b).uses.front());
        return angle && *angle >= kLeastAngle ? std::optional<double>(std::max(first->distance, second->distance))
                                              : std::nullopt;
    }

    /// Divides free edges where free edges that run along them end.
    /// @return whether there are any
    bool divide_at_ends() {
        std::vector<int> free;
        // By x coordinate: an edge, and which end: 0 the first, 1 the last.
        std::multimap<double, std::pair<int, std::size_t>> ends;
        for (int e = 0; e < static_cast<int>(topology_.edges.size()); ++e) {
            if (is_free(e)) {
                free.push_back(e);
                ends.emplace(end_of(e, 0).x(), std::pair(e, 0));
                ends.emplace(end_of(e, 1).x(), std::pair(e, 1));
            }
        }
        // All divisions are found before the first one is made, since it takes an end away from its edge.
        std::vector<std::vector<Division>> divisions(free.size());
        for (std::size_t k = 0; k < free.size(); ++k) {
            check_cancelled(progress_);
            Bnd_Box box;
            BRepBndLib::Add(live_.edges[static_cast<std::size_t>(free[k])], box);
            box.Enlarge(topology_.detail);
            const auto last = box.IsVoid() ? ends.begin() : ends.upper_bound(box.CornerMax().X());
            for (auto end = box.IsVoid() ? last : ends.lower_bound(box.CornerMin().X()); end != last; ++end) {
                const auto [other, i] = end->second;
                if (other != free[k] && !box.IsOut(to_pnt(end_of(other, static_cast<int>(i))))) {
                    add_division(free[k], other, i, divisions[k]);
                }
            }
        }
        bool divided = false;
        for (std::size_t k = 0; k < free.size(); ++k) {
            divided = divide(free[k], divisions[k]) || divided;
        }
        return divided;
    }

    struct Division {
        double t;
        int node;
    };

    /// Adds a division of this edge at an end of another edge that meets its inside, if the two run along each other
    /// there.
    void add_division(int e, int other, std::size_t end, std::vector<Division>& divisions) const {
        const double near = topology_.detail;
        const EdgeEvaluator& along = curve(e);
        const Answer foot =
            along.nearest(end_of(other, static_cast<int>(end)), parameter(e, 0.5), edge(e).t0, edge(e).t1);
        const auto from_ends = [&](const Vec3& p) {
            return std::min((p - along.point(edge(e).t0).point).norm(), (p - along.point(edge(e).t1).point).norm());
        };
        if (!foot.found() || foot.distance > near || from_ends(foot.point) <= 2.0 * near) {
            return;
        }
        // Distance from the end at which the other edge has to lie along this one, in lengths of detail.
        constexpr double kAlong = 8.0;
        const EdgeEvaluator& beside = curve(other);
        const double t0 = end == 0 ? edge(other).t0 : edge(other).t1;
        const double t1 = end == 0 ? edge(other).t1 : edge(other).t0;
        const Answer onward = beside.at_distance(t0, t1, kAlong * near);
        const Answer there =
            along.nearest(onward.found() ? onward.point : beside.point(t1).point, foot.t, edge(e).t0, edge(e).t1);
        if (there.found() && there.distance <= near) {
            divisions.push_back({foot.t, edge(other).nodes[end]});
        }
    }

    bool divide(int e, std::vector<Division>& divisions) {
        std::sort(divisions.begin(), divisions.end(),
                  [](const Division& a, const Division& b) { return std::tie(b.t, b.node) < std::tie(a.t, a.node); });
        const EdgeEvaluator& along = curve(e);
        std::optional<Vec3> last;
        for (const Division& division : divisions) {
            const Vec3 point = along.point(division.t).point;
            if (!last || (point - *last).norm() > 2.0 * topology_.detail) {
                EdgeJoining::divide(e, division.t, division.node);
                last = point;
            }
        }
        return !divisions.empty();
    }

    const Progress* progress_;
    std::vector<char> loose_;  // by face: whether it belongs to no shell
    int joined_ = 0;
    double largest_ = 0.0;  // distance of the edges that were joined, mm
};

}  // namespace

std::vector<int> join_loose_faces(Topology& topology, ShapeMap& live, const Progress* progress) {
    return LooseFaces(topology, live, progress).run();
}

}  // namespace mq::geometry

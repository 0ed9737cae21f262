// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/loose_faces.h"

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
#include "geometry/occt/topology/edge_joining.h"

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
        std::vector<Pair> pairs = near_pairs();
        std::sort(pairs.begin(), pairs.end());
        int joined = 0;
        double largest = 0.0;
        for (const Pair& pair : pairs) {
            check_cancelled(progress_);
            if (is_free(pair.a) && is_free(pair.b) && join(pair.a, pair.b, topology_.detail)) {
                ++joined;
                largest = std::max(largest, pair.distance);
            }
        }
        if (joined == 0) {
            return {};
        }
        rename_nodes();
        std::array<char, 120> text;
        std::snprintf(text.data(), text.size(), "edges of loose faces were joined in %d pair%s, at most %.2g mm apart",
                      joined, joined == 1 ? "" : "s", largest);
        topology_.faults.emplace_back(text.data());
        return orient();
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

    int face_of(int e) const { return topology_.uses[static_cast<std::size_t>(edge(e).uses.front())].face; }

    bool is_free(int e) const {
        const Edge& data = edge(e);
        return data.uses.size() == 1 && !data.degenerate && data.nodes[0] >= 0 && data.nodes[1] >= 0 &&
               !topology_.uses[static_cast<std::size_t>(data.uses.front())].internal &&
               loose_[static_cast<std::size_t>(face_of(e))] != 0 &&
               !topology_.faces[static_cast<std::size_t>(face_of(e))].no_area;
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
        // Radians: least angle between faces that are joined; those of copies lie on each other.
        constexpr double kLeast = 2.0 * kDegree;
        const std::optional<double> angle = dihedral_angle(edge(a).uses.front(), edge(b).uses.front());
        return angle && *angle >= kLeast ? std::optional<double>(std::max(first->distance, second->distance))
                                         : std::nullopt;
    }

    /// Turns faces so that those that are joined show the same side, and most stay as they are.
    std::vector<int> orient() {
        std::vector<int> result;
        std::vector<int> turned(topology_.faces.size(), -1);
        for (int f = 0; f < static_cast<int>(topology_.faces.size()); ++f) {
            if (loose_[static_cast<std::size_t>(f)] == 0 || turned[static_cast<std::size_t>(f)] >= 0) {
                continue;
            }
            const std::vector<int> group = connected_faces(f, turned);
            const auto count = std::count_if(group.begin(), group.end(),
                                             [&](int g) { return turned[static_cast<std::size_t>(g)] == 1; });
            const int turn = 2 * static_cast<std::size_t>(count) > group.size() ? 0 : 1;
            for (const int g : group) {
                if (turned[static_cast<std::size_t>(g)] == turn) {
                    Face& face = topology_.faces[static_cast<std::size_t>(g)];
                    face.reversed = !face.reversed;
                    result.push_back(g);
                }
            }
        }
        return result;
    }

    /// The faces that are joined to one, with 0 or 1 in `turned`: whether they are to be turned as that stays.
    std::vector<int> connected_faces(int face, std::vector<int>& turned) const {
        std::vector<int> group{face};
        turned[static_cast<std::size_t>(face)] = 0;
        for (std::size_t i = 0; i < group.size(); ++i) {
            for (const Loop& loop : topology_.faces[static_cast<std::size_t>(group[i])].loops) {
                for (const int use : loop.uses) {
                    add_neighbour(use, group, turned);
                }
            }
        }
        return group;
    }

    void add_neighbour(int use, std::vector<int>& group, std::vector<int>& turned) const {
        const EdgeUse& own = topology_.uses[static_cast<std::size_t>(use)];
        const std::vector<int>& uses = edge(own.edge).uses;
        if (uses.size() != 2 || edge(own.edge).degenerate) {
            return;
        }
        const EdgeUse& other = topology_.uses[static_cast<std::size_t>(uses[0] == use ? uses[1] : uses[0])];
        const auto f = static_cast<std::size_t>(other.face);
        if (loose_[f] == 0 || turned[f] >= 0) {
            return;
        }
        const auto runs = [&](const EdgeUse& u) {
            return u.forward != topology_.faces[static_cast<std::size_t>(u.face)].reversed;
        };
        const bool against = runs(own) == runs(other);
        turned[f] =
            against ? 1 - turned[static_cast<std::size_t>(own.face)] : turned[static_cast<std::size_t>(own.face)];
        group.push_back(other.face);
    }

    const Progress* progress_;
    std::vector<char> loose_;  // by face: whether it belongs to no shell
};

}  // namespace

std::vector<int> join_loose_faces(Topology& topology, ShapeMap& live, const Progress* progress) {
    return topology.detail > 0.0 ? LooseFaces(topology, live, progress).run() : std::vector<int>();
}

}  // namespace mq::geometry

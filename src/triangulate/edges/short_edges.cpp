// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/edges/short_edges.h"

#include <algorithm>
#include <utility>

#include "base/angle.h"
#include "base/disjoint_sets.h"
#include "geometry/detail.h"

namespace mq::triangulate {

namespace {

class ShortEdges {
  public:
    ShortEdges(const geometry::Topology& topology, const std::vector<std::vector<Vec3>>& points,
               const std::vector<double>& lengths)
        : topology_(topology), points_(points), lengths_(lengths), places_(topology.nodes.size()) {
        boxes_.resize(topology.nodes.size());
        for (std::size_t n = 0; n < boxes_.size(); ++n) {
            boxes_[n].add(topology.nodes[n].point);
        }
        for (int e = 0; e < static_cast<int>(lengths.size()); ++e) {
            if (is_vertex(e)) {
                unite_nodes(topology.edges[e]);
            }
        }
    }

    std::vector<int> run(const std::set<int>& kept) {
        std::vector<std::pair<double, int>> order;
        for (int e = 0; e < static_cast<int>(lengths_.size()); ++e) {
            const geometry::Edge& edge = topology_.edges[e];
            if (!is_vertex(e) && lengths_[e] < topology_.detail && edge.nodes[0] >= 0 && edge.nodes[1] >= 0 &&
                kept.count(e) == 0) {
                order.emplace_back(lengths_[e], e);
            }
        }
        std::sort(order.begin(), order.end());
        for (const auto& [length, e] : order) {
            if (may_contract(e)) {
                unite_nodes(topology_.edges[e]);
                lengths_[e] = 0.0;
                contracted_.push_back(e);
            }
        }
        return contracted_;
    }

  private:
    bool is_vertex(int edge) const { return !(lengths_[edge] > 0.0); }

    void unite_nodes(const geometry::Edge& edge) {
        if (edge.nodes[0] < 0 || edge.nodes[1] < 0) {
            return;
        }
        const int a = places_.find(edge.nodes[0]);
        const int b = places_.find(edge.nodes[1]);
        places_.unite(a, b);
        boxes_[std::min(a, b)].add(boxes_[std::max(a, b)]);
    }

    bool may_contract(int e) {
        const geometry::Edge& edge = topology_.edges[e];
        const int a = places_.find(edge.nodes[0]);
        const int b = places_.find(edge.nodes[1]);
        Box both = boxes_[a];
        both.add(boxes_[b]);
        if (a == b || (both.high - both.low).norm() > topology_.detail) {
            return false;
        }
        return std::all_of(edge.uses.begin(), edge.uses.end(), [&](int use) { return leaves_corner(use); });
    }

    // Whether the neighbours of a use on its loop still make a corner once it is a vertex.
    bool leaves_corner(int use) {
        const geometry::Face& face = topology_.faces[topology_.uses[use].face];
        for (const geometry::Loop& loop : face.loops) {
            const auto at = std::find(loop.uses.begin(), loop.uses.end(), use);
            if (at == loop.uses.end()) {
                continue;
            }
            const int i = static_cast<int>(at - loop.uses.begin());
            const int before = neighbour(loop, i, -1);
            const int after = neighbour(loop, i, 1);
            if (before < 0 || after < 0 || topology_.uses[before].edge == topology_.uses[after].edge ||
                joins_same_nodes(use, before) || joins_same_nodes(use, after)) {
                return false;
            }
            const Vec3 corner =
                0.5 * (points_[topology_.uses[use].edge].front() + points_[topology_.uses[use].edge].back());
            return angle_between(point_along(before, false) - corner, point_along(after, true) - corner) >=
                   geometry::DetailCorners::kLeastAngle;
        }
        return false;
    }

    // The next use on the loop that is not a vertex; -1: there is none.
    int neighbour(const geometry::Loop& loop, int i, int step) const {
        const int n = static_cast<int>(loop.uses.size());
        for (int k = 1; k < n; ++k) {
            const int use = loop.uses[(i + step * k + n * n) % n];
            if (!is_vertex(topology_.uses[use].edge)) {
                return use;
            }
        }
        return -1;
    }

    bool joins_same_nodes(int use, int other) {
        const auto ends = [&](int u) {
            const auto& nodes = topology_.edges[topology_.uses[u].edge].nodes;
            return nodes[0] < 0 || nodes[1] < 0 ? std::pair{-1, -1}
                                                : std::minmax({places_.find(nodes[0]), places_.find(nodes[1])});
        };
        return ends(use) == ends(other);
    }

    // The point of a use's polyline at DetailCorners::kReach details from its first or last end, or its other end if it
    // is shorter.
    Vec3 point_along(int use, bool from_start) const {
        const std::vector<Vec3>& points = points_[topology_.uses[use].edge];
        const bool ascending = topology_.uses[use].forward == from_start;
        const int n = static_cast<int>(points.size());
        double rest = geometry::DetailCorners::kReach * topology_.detail;
        for (int k = 1; k < n; ++k) {
            const Vec3& p = points[ascending ? k - 1 : n - k];
            const Vec3& q = points[ascending ? k : n - 1 - k];
            const double length = (q - p).norm();
            if (length >= rest) {
                return p + (rest / length) * (q - p);
            }
            rest -= length;
        }
        return ascending ? points.back() : points.front();
    }

    const geometry::Topology& topology_;
    const std::vector<std::vector<Vec3>>& points_;
    std::vector<double> lengths_;  // by edge, mm; 0: it is a vertex
    DisjointSets<int> places_;
    std::vector<Box> boxes_;  // by node: the root of a set of nodes at one place has the box of all of them
    std::vector<int> contracted_;
};

}  // namespace

std::vector<int> contractible_edges(const geometry::Topology& topology, const std::vector<std::vector<Vec3>>& points,
                                    const std::vector<double>& lengths, const std::set<int>& kept) {
    return ShortEdges(topology, points, lengths).run(kept);
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/measure/leak.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <tuple>

#include "base/key_set.h"

namespace mq::wrap {

namespace {

/// The node nearest to a point.
Node nearest_node(const Lattice& lattice, const Vec3& p) {
    const Vec3 at = (p - lattice.at({0, 0, 0})) / (0.5 * lattice.side());
    Node best{};
    double least = std::numeric_limits<double>::infinity();
    for (const int odd : {0, 1}) {
        Node node;
        for (std::size_t i = 0; i < 3; ++i) {
            node[i] = 2 * static_cast<std::int32_t>(std::lround((at[static_cast<int>(i)] - odd) / 2.0)) + odd;
        }
        const double distance = (lattice.at(node) - p).squaredNorm();
        if (distance < least) {
            least = distance;
            best = node;
        }
    }
    return best;
}

/// A search over the places of the ball's centre, from the dry place to a node beside the input's box.
class Search {
  public:
    Search(const NodeStates& states, const Progress& progress)
        : states_(states), lattice_(states.lattice()), box_(states.surface().tree.box()), pace_(progress) {}

    /// Over all paths the largest of their smallest distances from the input, mm.
    double widest(const Node& start) {
        return run(start, -std::numeric_limits<double>::infinity(), [this](const Node& node, double so_far, double) {
            return std::max(so_far, -states_.surface().tree.nearest(lattice_.at(node)).distance);
        });
    }
    /// The shortest path on which the distance from the input is at least `distance`.
    void shortest(const Node& start, double distance) {
        run(start, 0.0, [this, distance](const Node& node, double so_far, double step) {
            const double own = states_.surface().tree.nearest(lattice_.at(node)).distance;
            return own < distance ? std::numeric_limits<double>::infinity() : so_far + step;
        });
    }
    /// The nodes of the last path, from its start.
    std::vector<Node> way() const {
        std::vector<Node> nodes;
        for (Node node = end_;; node = from_.at(Lattice::key(node))) {
            nodes.push_back(node);
            if (from_.at(Lattice::key(node)) == node) {
                break;
            }
        }
        std::reverse(nodes.begin(), nodes.end());
        return nodes;
    }

  private:
    struct Entry {
        double cost;
        Node node;
        Node from;
        bool operator<(const Entry& o) const { return std::tie(o.cost, o.node, o.from) < std::tie(cost, node, from); }
    };

    /// Dijkstra's algorithm. cost(node, cost before, length of the step) must not fall along a path; at its start it is
    /// `before`. @return the cost of the path's end, negative for distances.
    template <typename Cost>
    double run(const Node& start, double before, const Cost& cost) {
        from_.clear();
        std::priority_queue<Entry> queue;
        queue.push({cost(start, before, 0.0), start, start});
        while (!queue.empty()) {
            pace_.step();
            const Entry next = queue.top();
            queue.pop();
            if (!from_.insert({Lattice::key(next.node), next.from}).second) {
                continue;
            }
            end_ = next.node;
            if (!box_.contains(lattice_.at(next.node))) {
                return next.cost;
            }
            for_each_neighbour(lattice_, next.node, [&](const Node& other, int step) {
                if (states_.is_free(other) && states_.is_outside(other) &&
                    from_.find(Lattice::key(other)) == from_.end()) {
                    const double there = cost(other, next.cost, lattice_.length_of_step(step));
                    if (there < std::numeric_limits<double>::infinity()) {
                        queue.push({there, other, next.node});
                    }
                }
            });
        }
        return 0.0;
    }

    const NodeStates& states_;
    const Lattice& lattice_;
    Box box_;
    CancelPace pace_;
    KeyMap<Node> from_;
    Node end_{};
};

}  // namespace

std::optional<Leak> find_leak(const NodeStates& states, const Vec3& dry, const Progress& progress) {
    const Lattice& lattice = states.lattice();
    Node start = nearest_node(lattice, dry);
    if (!lattice.contains(start) || !states.is_outside(start)) {
        return std::nullopt;
    }
    if (const NodeState* state = states.find(start)) {
        // A node in a pocket has no ball: the search starts at the centre of the ball beside it.
        start = start + Node{state->to_ball[0], state->to_ball[1], state->to_ball[2]};
    }
    if (!states.is_free(start)) {
        return std::nullopt;
    }
    Search search(states, progress);
    const double clear = -search.widest(start);
    search.shortest(start, clear);
    Leak leak;
    leak.dry = dry;
    leak.width = std::numeric_limits<double>::infinity();
    leak.path.push_back(dry);
    for (const Node& node : search.way()) {
        const Vec3 place = lattice.at(node);
        const double width = 2.0 * states.surface().tree.nearest(place).distance;
        if (width < leak.width) {
            leak.width = width;
            leak.narrowest = place;
        }
        leak.path.push_back(place);
    }
    return leak;
}

}  // namespace mq::wrap

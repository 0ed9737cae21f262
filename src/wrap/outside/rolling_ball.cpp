// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/outside/rolling_ball.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "base/key_set.h"

namespace mq::wrap {

namespace {

/// Finds the places that the ball's centre can reach from the corner of the lattice.
class Flood {
  public:
    Flood(NodeStates& states, Progress& progress) : states_(states), lattice_(states.lattice()), pace_(progress) {}

    void run() {
        enter(Node{0, 0, 0});
        while (!blocks_.empty() || !nodes_.empty()) {
            pace_.step();
            if (!nodes_.empty()) {
                const Node node = nodes_.back();
                nodes_.pop_back();
                for_each_neighbour(lattice_, node, [&](const Node& other, int) { enter(other); });
            } else {
                const std::size_t block = blocks_.back();
                blocks_.pop_back();
                leave_block(lattice_.block_at(block));
            }
        }
    }

  private:
    void enter(const Node& node) {
        NodeState* state = states_.find(node);
        if (state == nullptr) {
            const std::size_t block = lattice_.block_of(node);
            if (!states_.is_outside_block(block)) {
                states_.set_outside_block(block);
                blocks_.push_back(block);
            }
        } else if (state->free && !state->outside) {
            state->outside = true;
            nodes_.push_back(node);
        }
    }
    void leave_block(const std::array<std::int32_t, 3>& block) {
        constexpr std::int32_t kAcross = Lattice::kAcross;
        const Node low{kAcross * block[0], kAcross * block[1], kAcross * block[2]};
        for (int place = 0; place < Lattice::kBlockNodes; ++place) {
            const Node node = Lattice::node_at(block, place);
            bool border = false;
            for (std::size_t i = 0; i < 3; ++i) {
                border = border || node[i] - low[i] < 2 || node[i] - low[i] >= kAcross - 2;
            }
            if (border) {
                for_each_neighbour(lattice_, node, [&](const Node& other, int) { enter(other); });
            }
        }
    }

    NodeStates& states_;
    const Lattice& lattice_;
    CancelPace pace_;
    std::vector<std::size_t> blocks_;
    std::vector<Node> nodes_;
};

/// Finds the nodes in the empty balls around the centres. The distance of a centre from the input is larger than the
/// radius, and the ball of that distance around it is empty: that whole ball is covered, so that the distance between
/// centres makes no node beside the input be missed.
class RollingBall {
  public:
    RollingBall(NodeStates& states, Progress& progress)
        : states_(states), lattice_(states.lattice()), progress_(progress), pace_(progress), lowest_(states.size()) {}

    void run() {
        double covered = 1.0;
        std::int32_t nearest = 0;  // to the last centre, from which that of the next one is found sooner
        states_.for_each_node(progress_, 0.1, 0.4, [&](const Node& node, const NodeState& state) {
            covered += !state.free;
            if (state.free && state.outside && has_covered_neighbour(node)) {
                const mesh::ClosestPoint closest = states_.surface().tree.nearest_from(lattice_.at(node), nearest);
                nearest = closest.triangle;
                balls_.push_back({node, closest.distance});
                spread(node, static_cast<std::uint32_t>(balls_.size() - 1));
            }
        });
        double reached = 0.0;
        while (!queue_.empty()) {
            pace_.step();
            const Reached next = queue_.top();
            queue_.pop();
            const Node node = states_.node_of(next.node);
            NodeState& state = *states_.find(node);
            if (state.outside) {
                continue;
            }
            state.outside = true;
            progress_.advance(0.4 + 0.3 * ++reached / covered);
            const Node& centre = balls_[next.ball].centre;
            for (std::size_t i = 0; i < 3; ++i) {
                state.to_ball[i] = static_cast<std::int16_t>(centre[i] - node[i]);
            }
            spread(node, next.ball);
        }
    }

  private:
    struct Ball {
        Node centre;
        double radius;
    };
    struct Reached {
        double height;       ///< mm: height above the ball's surface, at most 0
        std::uint32_t node;  ///< its index among the stored nodes
        std::uint32_t ball;  ///< its index
        bool operator<(const Reached& o) const {
            return std::tie(o.height, o.node, o.ball) < std::tie(height, node, ball);
        }
    };

    bool has_covered_neighbour(const Node& node) const {
        return std::any_of(Lattice::steps().begin(), Lattice::steps().end(), [&](const Node& step) {
            const Node other = node + step;
            return lattice_.contains(other) && !states_.is_free(other);
        });
    }
    void spread(const Node& node, std::uint32_t index) {
        const Ball& ball = balls_[index];
        for_each_neighbour(lattice_, node, [&](const Node& other, int step) {
            const NodeState* state = states_.find(other);
            if (state == nullptr || state->free || state->outside || states_.is_barred(node, step)) {
                return;
            }
            const double height = (lattice_.at(other) - lattice_.at(ball.centre)).norm() - ball.radius;
            // Among the balls in the queue that reach a node, the one with the least height takes it.
            const std::size_t there = states_.index_of(other);
            float& lowest = lowest_[there];
            if (height <= lowest) {
                lowest = std::nextafter(static_cast<float>(height), 1.0F);
                queue_.push({height, static_cast<std::uint32_t>(there), index});
            }
        });
    }

    NodeStates& states_;
    const Lattice& lattice_;
    Progress& progress_;
    CancelPace pace_;
    std::vector<Ball> balls_;
    std::priority_queue<Reached> queue_;
    /// By node, the least height of the entries that were put into the queue, or slightly more.
    std::vector<float> lowest_;
};

/// Finds what lies behind the nodes that the ball covers, by shortest paths from these.
class Pockets {
  public:
    Pockets(NodeStates& states, double depth, Progress& progress)
        : states_(states), lattice_(states.lattice()), depth_(depth), progress_(progress), pace_(progress) {}

    void run() {
        states_.for_each_node(progress_, 0.7, 0.8, [&](const Node& node, const NodeState& state) {
            if (state.outside && !state.free) {
                spread(node, 0.0, kOutside);
            }
        });
        find_ways();
        find_gaps();
        for (Way& way : ways_) {
            way.gap = way.gap || (way.from != kOutside && ways_[way.from].gap);
            if (!way.gap) {
                states_.find(way.node)->outside = true;
            }
        }
    }

  private:
    static constexpr std::size_t kOutside = std::numeric_limits<std::size_t>::max();

    struct Way {
        double length;
        Node node;
        std::size_t from;  ///< the path that this one continues
        bool gap =
            false;  ///< whether it, or one it continues, is longer than the pocket depth: its end belongs to a gap
        bool operator<(const Way& o) const { return std::tie(o.length, o.node, o.from) < std::tie(length, node, from); }
    };

    void spread(const Node& node, double length, std::size_t from) {
        for_each_neighbour(lattice_, node, [&](const Node& other, int step) {
            const NodeState* state = states_.find(other);
            const double there = length + lattice_.length_of_step(step);
            if (state != nullptr && !state->free && !state->outside && there <= depth_ &&
                !states_.is_barred(node, step)) {
                queue_.push({there, other, from});
            }
        });
    }
    /// Finds the paths in the order of their lengths.
    void find_ways() {
        while (!queue_.empty()) {
            pace_.step();
            const Way next = queue_.top();
            queue_.pop();
            if (way_of_.insert({Lattice::key(next.node), ways_.size()}).second) {
                ways_.push_back(next);
                spread(next.node, next.length, ways_.size() - 1);
            }
        }
    }
    /// Marks the paths that lead to nodes deeper than the pocket depth.
    void find_gaps() {
        for (std::size_t k = ways_.size(); k-- > 0;) {
            Way& way = ways_[k];
            for_each_neighbour(lattice_, way.node, [&](const Node& other, int step) {
                way.gap = way.gap || (!states_.is_outside(other) && !states_.is_barred(way.node, step) &&
                                      way_of_.find(Lattice::key(other)) == way_of_.end());
            });
            if (way.gap && way.from != kOutside) {
                ways_[way.from].gap = true;
            }
        }
    }

    NodeStates& states_;
    const Lattice& lattice_;
    double depth_;
    Progress& progress_;
    CancelPace pace_;
    std::priority_queue<Way> queue_;
    std::vector<Way> ways_;
    KeyMap<std::size_t> way_of_;
};

}  // namespace

void roll_ball(NodeStates& states, double pocket, Progress& progress) {
    Flood(states, progress).run();
    RollingBall(states, progress).run();
    Pockets(states, pocket, progress).run();
}

}  // namespace mq::wrap

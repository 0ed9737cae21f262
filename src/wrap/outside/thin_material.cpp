// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/outside/thin_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "wrap/lattice/tuning.h"

namespace mq::wrap {

namespace {

double volume(const std::array<Vec3, 4>& c) {
    return (c[1] - c[0]).cross(c[2] - c[0]).dot(c[3] - c[0]) / 6.0;
}

/// A place in material on an edge between two nodes outside.
struct Middle {
    Vec3 place = Vec3::Zero();
    double width = -1.0;  ///< width of the material along the edge, mm; below 0: there is none
};

class ThinMaterial {
  public:
    ThinMaterial(NodeStates& states, const Progress& progress)
        : states_(states), lattice_(states.lattice()), pace_(progress) {}

    void run() {
        for (const std::array<std::int32_t, 3>& block : states_.blocks()) {
            for (int place = 0; place < Lattice::kBlockNodes; ++place) {
                pace_.step();
                const Node node = Lattice::node_at(block, place);
                const NodeState& state = *states_.find(node);
                if (state.outside && state.near) {
                    treat(node);
                }
            }
        }
    }

  private:
    void treat(const Node& node) {
        Middle widest;
        for_each_neighbour(lattice_, node, [&](const Node& other, int step) {
            if (states_.is_outside(other) && states_.is_barred(node, step)) {
                const Middle found = middle_between(states_.position(node), states_.position(other));
                widest = found.width > widest.width ? found : widest;
            }
        });
        if (widest.width <= 0.0) {
            return;
        }
        states_.move(node, widest.place);
        if (keeps_cells(node)) {
            states_.bar_edges_at(node);
            if (closed_to_outside(node)) {
                states_.find(node)->outside = false;
                return;
            }
            states_.move_back(node);
            states_.bar_edges_at(node);
            return;
        }
        states_.move_back(node);
    }

    /// The middle of the material that an edge enters first, where it is nearer to the start than to the end.
    Middle middle_between(const Vec3& from, const Vec3& to) const {
        const FirstMeeting first = states_.surface().first_meeting(from, to);
        const FirstMeeting last = states_.surface().first_meeting(to, from);
        const double leaves = 1.0 - last.share;
        const double middle = 0.5 * (first.share + leaves);
        if (middle > 0.5 || first.triangle == last.triangle) {
            return {};
        }
        return {from + middle * (to - from), (leaves - first.share) * (to - from).norm()};
    }

    bool keeps_cells(const Node& node) const {
        bool keeps = true;
        for_each_tetrahedron_at(node, [&](const std::array<Node, 4>& cell) {
            std::array<Vec3, 4> at;
            std::array<Vec3, 4> was;
            for (std::size_t k = 0; k < 4; ++k) {
                at[k] = states_.position(cell[k]);
                was[k] = lattice_.at(cell[k]);
            }
            keeps = keeps && volume(at) / volume(was) >= WrapTuning::kFlatCell;
        });
        return keeps;
    }
    bool closed_to_outside(const Node& node) const {
        bool closed = true;
        for_each_neighbour(lattice_, node, [&](const Node& other, int step) {
            closed = closed && (!states_.is_outside(other) || states_.is_barred(node, step));
        });
        return closed;
    }

    NodeStates& states_;
    const Lattice& lattice_;
    CancelPace pace_;
};

}  // namespace

void move_into_thin_material(NodeStates& states, const Progress& progress) {
    ThinMaterial(states, progress).run();
}

namespace {

/// Edges by which a sheet goes on into material that the lattice resolves.
constexpr int kOverlap = 3;

/// Edges between nodes outside that meet the input.
class ThinEdges {
  public:
    ThinEdges(NodeStates& states, const Progress& progress)
        : states_(states), lattice_(states.lattice()), pace_(progress) {}

    /// Returns the number of nodes that became a sheet.
    std::size_t run() {
        std::vector<Node> front;
        for (const std::array<std::int32_t, 3>& block : states_.blocks()) {
            pace_.step();
            for (int place = 0; place < Lattice::kBlockNodes; ++place) {
                const Node node = Lattice::node_at(block, place);
                const NodeState& state = *states_.find(node);
                if (state.outside && state.near && has_thin_edge(node) && !is_held(node)) {
                    front.push_back(node);
                }
            }
        }
        for (const Node& node : front) {
            chosen_.insert(Lattice::key(node));
        }
        std::vector<Node> all = front;
        for (int ring = 0; ring < kOverlap; ++ring) {
            front = grown(front);
            all.insert(all.end(), front.begin(), front.end());
        }
        return mark(all);
    }

  private:
    template <typename Visit>
    void for_each_thin_edge(const Node& node, const Visit& visit) const {
        for_each_neighbour(lattice_, node, [&](const Node& other, int step) {
            if (states_.is_outside(other) && states_.is_barred(node, step)) {
                visit(other);
            }
        });
    }
    bool has_thin_edge(const Node& node) const {
        bool has = false;
        for_each_thin_edge(node, [&](const Node&) { has = true; });
        return has;
    }
    /// Whether a node beside it is not outside: the wrap then passes within a side.
    bool is_held(const Node& node) const {
        bool held = false;
        for_each_neighbour(lattice_, node, [&](const Node& other, int) { held = held || !states_.is_outside(other); });
        return held;
    }
    /// The nodes at thin edges of some nodes that are not chosen yet; chooses them.
    std::vector<Node> grown(const std::vector<Node>& front) {
        std::vector<Node> next;
        for (const Node& node : front) {
            pace_.step();
            for_each_thin_edge(node, [&](const Node& other) {
                if (chosen_.insert(Lattice::key(other)).second) {
                    next.push_back(other);
                }
            });
        }
        return next;
    }
    std::size_t mark(const std::vector<Node>& nodes) {
        std::size_t count = 0;
        const double half = 0.5 * lattice_.side();
        for (const Node& node : nodes) {
            pace_.step();
            if (states_.surface().tree.any_within(states_.position(node), half, 0) >= 0) {
                NodeState& state = *states_.find(node);
                state.outside = false;
                state.sheet = true;
                ++count;
            }
        }
        return count;
    }

    NodeStates& states_;
    const Lattice& lattice_;
    CancelPace pace_;
    KeySet chosen_;
};

}  // namespace

std::size_t mark_sheets(NodeStates& states, const Progress& progress) {
    return ThinEdges(states, progress).run();
}

}  // namespace mq::wrap

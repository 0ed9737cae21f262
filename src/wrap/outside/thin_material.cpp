// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/outside/thin_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wrap/lattice/tuning.h"

namespace mq::wrap {

namespace {

double volume(const std::array<Vec3, 4>& c) {
    return (c[1] - c[0]).cross(c[2] - c[0]).dot(c[3] - c[0]) / 6.0;
}

/// The middle of the material on an edge between two nodes outside.
struct Middle {
    Vec3 place = Vec3::Zero();
    double width = -1.0;  ///< mm: width of the material along the edge; negative: there is no material
};

class ThinMaterial {
  public:
    explicit ThinMaterial(NodeStates& states) : states_(states), lattice_(states.lattice()) {}

    void run(Progress& progress) {
        states_.for_each_node(progress, 0.0, 0.5, [&](const Node& node, const NodeState& state) {
            if (state.outside && state.near) {
                move_into_widest(node);
            }
        });
    }

  private:
    /// Moves a node into the material on one of its edges, the widest first, if that is possible.
    void move_into_widest(const Node& node) {
        std::vector<Middle> middles;
        for_each_neighbour(lattice_, node, [&](const Node& other, int step) {
            if (states_.is_outside(other) && states_.is_barred(node, step)) {
                middles.push_back(middle_between(states_.position(node), states_.position(other)));
            }
        });
        std::stable_sort(middles.begin(), middles.end(),
                         [](const Middle& one, const Middle& two) { return one.width > two.width; });
        for (const Middle& middle : middles) {
            if (middle.width > 0.0 && try_to_move(node, middle.place)) {
                return;
            }
        }
    }
    /// Moves a node if that is allowed. @return whether it was moved; else it is at its former place.
    bool try_to_move(const Node& node, const Vec3& place) {
        states_.move(node, place);
        if (keeps_cells(node)) {
            states_.bar_edges_at(node);
            if (closed_to_outside(node)) {
                states_.find(node)->outside = false;
                return true;
            }
            states_.move_back(node);
            states_.bar_edges_at(node);
            return false;
        }
        states_.move_back(node);
        return false;
    }

    /// The middle of the material that an edge enters first, if it is nearer to the start than to the end.
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
};

}  // namespace

void move_into_thin_material(NodeStates& states, Progress& progress) {
    ThinMaterial(states).run(progress);
}

std::size_t mark_sheets(NodeStates& states, Progress& progress) {
    const Lattice& lattice = states.lattice();
    const double half = 0.5 * lattice.side();
    std::vector<Node> sheet;
    states.for_each_node(progress, 0.5, 1.0, [&](const Node& node, const NodeState& state) {
        bool is_thin = false;
        if (state.outside && state.near) {
            for_each_neighbour(lattice, node, [&](const Node& other, int step) {
                is_thin = is_thin || (states.is_outside(other) && states.is_barred(node, step));
            });
        }
        if (is_thin && states.surface().tree.any_within(lattice.at(node), half, 0) >= 0) {
            sheet.push_back(node);
        }
    });
    for (const Node& node : sheet) {
        NodeState& state = *states.find(node);
        state.outside = false;
        state.sheet = true;
    }
    return sheet.size();
}

}  // namespace mq::wrap

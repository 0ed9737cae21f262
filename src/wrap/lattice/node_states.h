// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "base/progress.h"
#include "wrap/lattice/input_surface.h"
#include "wrap/lattice/lattice.h"

namespace mq::wrap {

/// The state of a node.
struct NodeState {
    bool free : 1;     ///< its distance from the input is at least the ball's radius
    bool near : 1;     ///< its distance from the input is at most a side: its edges may meet it
    bool outside : 1;  ///< in the space that is outside of the wrap
    bool moved : 1;    ///< it was moved from its place in the lattice
    bool sheet : 1;    ///< in material thinner than the lattice resolves, to which the wrap gives a thickness
    /// Bit k: the edge of step k < 7 meets the input.
    std::uint8_t barred = 0;
    /// The step from the node to the centre of the ball that reached it; 0 for free nodes.
    std::array<std::int16_t, 3> to_ball{};

    NodeState() : free(false), near(false), outside(false), moved(false), sheet(false) {}
};

/// The nodes near the input, in blocks, and which of the other blocks are outside. In blocks that are not stored all
/// nodes are free and on one side.
class NodeStates {
  public:
    /// Determines free and near nodes and barred edges, in parallel.
    /// @param radius  mm, of the ball: at least the side
    /// @throws InvalidInput if the nodes would take more than kMostBytes of memory, or have no unique keys
    /// @throws Cancelled
    NodeStates(const Lattice& lattice, const InputSurface& surface, double radius, Progress& progress);

    const Lattice& lattice() const { return lattice_; }
    const InputSurface& surface() const { return surface_; }

    /// The state of a node; null if its block is not stored.
    NodeState* find(const Node& node) {
        const std::int32_t slot = slots_[lattice_.block_of(node)];
        return slot < 0 ? nullptr : &states_[static_cast<std::size_t>(slot)][Lattice::place_in_block(node)];
    }
    const NodeState* find(const Node& node) const { return const_cast<NodeStates*>(this)->find(node); }
    /// The index of a node among the stored nodes; its block must be stored.
    std::size_t index_of(const Node& node) const {
        return static_cast<std::size_t>(slots_[lattice_.block_of(node)]) * Lattice::kBlockNodes +
               static_cast<std::size_t>(Lattice::place_in_block(node));
    }
    Node node_of(std::size_t index) const {
        return Lattice::node_at(blocks_[index / Lattice::kBlockNodes], static_cast<int>(index % Lattice::kBlockNodes));
    }
    /// The number of stored nodes; it fits into 32 bits, as the memory is limited.
    std::size_t size() const { return states_.size() * Lattice::kBlockNodes; }
    bool is_outside(const Node& node) const {
        const std::int32_t slot = slots_[lattice_.block_of(node)];
        return slot < 0 ? slot == kOutsideBlock
                        : states_[static_cast<std::size_t>(slot)][Lattice::place_in_block(node)].outside;
    }
    bool is_free(const Node& node) const {
        const NodeState* state = find(node);
        return state == nullptr || state->free;
    }
    /// The position of a node.
    Vec3 position(const Node& node) const {
        const NodeState* state = find(node);
        return state != nullptr && state->moved ? moved_.at(Lattice::key(node)) : lattice_.at(node);
    }
    /// Moves a node; bar_edges_at() must be called for it afterwards.
    void move(const Node& node, const Vec3& place);
    void move_back(const Node& node);
    /// Determines which of the 14 edges at a node meet the input.
    void bar_edges_at(const Node& node);
    /// Whether the edge of a step meets the input.
    bool is_barred(const Node& node, int step) const;

    /// Calls visit(node, its state) for all nodes of the stored blocks, in ascending order of the blocks.
    /// @param from, to  the fractions of the stage between which the progress advances
    /// @throws Cancelled
    template <typename Visit>
    void for_each_node(Progress& progress, double from, double to, const Visit& visit) {
        for (std::size_t k = 0; k < blocks_.size(); ++k) {
            progress.check();
            progress.advance(from + (to - from) * static_cast<double>(k) / static_cast<double>(blocks_.size()));
            for (int place = 0; place < Lattice::kBlockNodes; ++place) {
                visit(Lattice::node_at(blocks_[k], place), states_[k][place]);
            }
        }
    }
    /// The stored blocks, ascending.
    const std::vector<std::array<std::int32_t, 3>>& blocks() const { return blocks_; }
    bool is_outside_block(std::size_t block) const { return slots_[block] == kOutsideBlock; }
    void set_outside_block(std::size_t block) { slots_[block] = kOutsideBlock; }

  private:
    static constexpr std::int32_t kFreeBlock = -1;
    static constexpr std::int32_t kOutsideBlock = -2;
    using BlockStates = std::array<NodeState, Lattice::kBlockNodes>;

    void find_blocks(const Progress& progress);
    void find_blocks_in(const std::array<std::int32_t, 3>& low, std::int32_t across, std::int32_t guess,
                        std::vector<std::array<std::int32_t, 3>>& found) const;
    void classify(std::size_t block);
    void classify_eighth(std::size_t block, int eighth);
    void bar_edges(std::size_t block);

    const Lattice& lattice_;
    const InputSurface& surface_;
    double radius_;
    std::vector<std::int32_t> slots_;  ///< by block: the index of its states, or kFreeBlock or kOutsideBlock
    std::vector<std::array<std::int32_t, 3>> blocks_;
    std::vector<BlockStates> states_;
    KeyMap<Vec3> moved_;
};

}  // namespace mq::wrap

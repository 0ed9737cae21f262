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

/// What is known of a node.
struct NodeState {
    bool free : 1;     ///< at least the ball's radius from the input
    bool near : 1;     ///< at most a side from the input: its edges may meet it
    bool outside : 1;  ///< in the space that the wrap leaves outside
    bool moved : 1;    ///< not at its place in the lattice
    bool sheet : 1;    ///< in material thinner than the lattice resolves, to which the wrap gives a thickness
    /// Bit k: the edge of step k < 7 meets the input.
    std::uint8_t barred = 0;
    /// The step from the node to the centre of the ball that reached it; 0 of free ones.
    std::array<std::int16_t, 3> to_ball{};

    NodeState() : free(false), near(false), outside(false), moved(false), sheet(false) {}
};

/// The nodes near the input, by blocks, and which of the other blocks are outside. Nodes of blocks that are not kept
/// are free, and all on one side.
class NodeStates {
  public:
    /// Determines free and near nodes and barred edges, in parallel.
    /// @param radius  of the ball, mm, at least the side
    /// @throws InvalidInput where the nodes would take more than kMostBytes of memory, or have no keys
    /// @throws Cancelled
    NodeStates(const Lattice& lattice, const InputSurface& surface, double radius, Progress& progress);

    const Lattice& lattice() const { return lattice_; }
    const InputSurface& surface() const { return surface_; }

    /// Null where its block is not kept.
    NodeState* find(const Node& node) {
        const std::int32_t slot = slots_[lattice_.block_of(node)];
        return slot < 0 ? nullptr : &states_[static_cast<std::size_t>(slot)][Lattice::place_in_block(node)];
    }
    const NodeState* find(const Node& node) const { return const_cast<NodeStates*>(this)->find(node); }
    /// Which of the nodes that are kept it is; its block is.
    std::size_t index_of(const Node& node) const {
        return static_cast<std::size_t>(slots_[lattice_.block_of(node)]) * Lattice::kBlockNodes +
               static_cast<std::size_t>(Lattice::place_in_block(node));
    }
    /// The number of nodes that are kept.
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
    /// Where a node is.
    Vec3 position(const Node& node) const {
        const NodeState* state = find(node);
        return state != nullptr && state->moved ? moved_.at(Lattice::key(node)) : lattice_.at(node);
    }
    /// Puts a node elsewhere; its edges must be barred anew (bar_edges_at).
    void move(const Node& node, const Vec3& place);
    void move_back(const Node& node);
    /// Determines which of the 14 edges at a node meet the input.
    void bar_edges_at(const Node& node);
    /// Whether the edge of a step meets the input.
    bool is_barred(const Node& node, int step) const;

    /// visit(node, its state) for all nodes of the blocks that are kept, by ascending blocks.
    /// @param from, to  the fractions of the stage that this covers
    /// @throws Cancelled
    template <typename Visit>
    void for_each_node(Progress& progress, double from, double to, const Visit& visit) {
        double done = 0.0;
        for (const std::array<std::int32_t, 3>& block : blocks_) {
            progress.check();
            progress.advance(from + (to - from) * done++ / static_cast<double>(blocks_.size()));
            for (int place = 0; place < Lattice::kBlockNodes; ++place) {
                const Node node = Lattice::node_at(block, place);
                visit(node, *find(node));
            }
        }
    }
    /// Blocks kept, ascending.
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
    std::vector<std::int32_t> slots_;  ///< for each block: where its states are, else kFreeBlock or kOutsideBlock
    std::vector<std::array<std::int32_t, 3>> blocks_;
    std::vector<BlockStates> states_;
    KeyMap<Vec3> moved_;
};

}  // namespace mq::wrap

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/lattice/node_states.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/error.h"
#include "base/message.h"
#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::wrap {

namespace {

/// Memory for states of nodes, bytes.
constexpr double kMostBytes = 2e9;
/// Blocks along the cubes at which the search for blocks begins.
constexpr std::int32_t kCoarse = 8;

}  // namespace

NodeStates::NodeStates(const Lattice& lattice, const InputSurface& surface, double radius, Progress& progress)
    : lattice_(lattice), surface_(surface), radius_(radius) {
    find_blocks(progress);
    states_.resize(blocks_.size());
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
        slots_[lattice_.block_index(blocks_[k])] = static_cast<std::int32_t>(k);
    }
    std::atomic<int> done{0};
    for_chunks(static_cast<int>(blocks_.size()), [&](int k) {
        progress.check();
        classify(static_cast<std::size_t>(k));
        // Half of the stage, as finding the barred edges takes about as long.
        progress.advance(0.5 * ++done / static_cast<double>(blocks_.size()));
    });
    for_chunks(static_cast<int>(blocks_.size()), [&](int k) {
        progress.check();
        bar_edges(static_cast<std::size_t>(k));
        progress.advance(0.5 * ++done / static_cast<double>(blocks_.size()));
    });
}

void NodeStates::find_blocks(const Progress& progress) {
    const double most = kMostBytes / sizeof(BlockStates);
    const auto refuse = [&] { throw InvalidInput(phrases::kWrapMemory, {{"length", in_mm(lattice_.side())}}); };
    if (static_cast<double>(lattice_.block_count()) * sizeof(std::int32_t) > kMostBytes) {
        refuse();
    }
    if (!lattice_.has_keys()) {
        throw InvalidInput(phrases::kWrapAcross,
                           {{"count", Lattice::kMostAcross / 2}, {"length", in_mm(lattice_.side())}});
    }
    slots_.assign(lattice_.block_count(), kFreeBlock);
    std::vector<std::array<std::int32_t, 3>> starts;
    for (std::int32_t x = 0; x < lattice_.blocks()[0]; x += kCoarse) {
        for (std::int32_t y = 0; y < lattice_.blocks()[1]; y += kCoarse) {
            for (std::int32_t z = 0; z < lattice_.blocks()[2]; z += kCoarse) {
                starts.push_back({x, y, z});
            }
        }
    }
    std::vector<std::vector<std::array<std::int32_t, 3>>> found(starts.size());
    parallel_for(static_cast<int>(starts.size()), [&](int k) {
        progress.check();
        find_blocks_in(starts[static_cast<std::size_t>(k)], kCoarse, 0, found[static_cast<std::size_t>(k)]);
    });
    std::size_t count = 0;
    for (const auto& some : found) {
        count += some.size();
    }
    if (static_cast<double>(count) > most) {
        refuse();
    }
    for (const auto& some : found) {
        blocks_.insert(blocks_.end(), some.begin(), some.end());
    }
    std::sort(blocks_.begin(), blocks_.end());
}

void NodeStates::find_blocks_in(const std::array<std::int32_t, 3>& low, std::int32_t across, std::int32_t guess,
                                std::vector<std::array<std::int32_t, 3>>& found) const {
    for (std::size_t i = 0; i < 3; ++i) {
        if (low[i] >= lattice_.blocks()[i]) {
            return;
        }
    }
    const double half = 0.25 * lattice_.side() * Lattice::kAcross * across;
    const Vec3 centre = lattice_.at({Lattice::kAcross * low[0], Lattice::kAcross * low[1], Lattice::kAcross * low[2]}) +
                        Vec3::Constant(half);
    // If a node is not free, the blocks of all of its neighbours are stored as well.
    const double reach = radius_ + lattice_.side() + std::sqrt(3.0) * half;
    const std::int32_t near = surface_.tree.any_within(centre, reach, guess);
    if (near < 0) {
        return;
    }
    if (across == 1) {
        found.push_back(low);
        return;
    }
    for (int k = 0; k < 8; ++k) {
        const std::int32_t half_across = across / 2;
        find_blocks_in(
            {low[0] + (k & 1) * half_across, low[1] + (k >> 1 & 1) * half_across, low[2] + (k >> 2) * half_across},
            half_across, near, found);
    }
}

void NodeStates::classify(std::size_t block) {
    for (int eighth = 0; eighth < 8; ++eighth) {
        classify_eighth(block, eighth);
    }
}

void NodeStates::classify_eighth(std::size_t block, int eighth) {
    const std::array<std::int32_t, 3>& at = blocks_[block];
    const Node low{Lattice::kAcross * at[0] + 4 * (eighth & 1), Lattice::kAcross * at[1] + 4 * (eighth >> 1 & 1),
                   Lattice::kAcross * at[2] + 4 * (eighth >> 2)};
    const double side = lattice_.side();
    const Vec3 centre = lattice_.at(low) + Vec3::Constant(0.75 * side);
    const double half = 0.75 * std::sqrt(3.0) * side;
    const mesh::ClosestPoint nearest = surface_.tree.nearest(centre, radius_ + half);
    const bool all_free = nearest.triangle < 0;
    for (int k = 0; k < 16; ++k) {
        const int odd = k & 1;
        const Node node{low[0] + 2 * (k >> 1 & 1) + odd, low[1] + 2 * (k >> 2 & 1) + odd, low[2] + 2 * (k >> 3) + odd};
        NodeState& state = states_[block][Lattice::place_in_block(node)];
        const Vec3 p = lattice_.at(node);
        // The distance of a node differs from that of the centre by at most its distance from the centre.
        const double away = (p - centre).norm();
        state.near =
            !all_free && nearest.distance - away <= side && surface_.tree.any_within(p, side, nearest.triangle) >= 0;
        state.free = all_free || (!state.near && nearest.distance + away >= radius_ &&
                                  surface_.tree.any_within(p, radius_, nearest.triangle) < 0);
    }
}

void NodeStates::bar_edges(std::size_t block) {
    for (int place = 0; place < Lattice::kBlockNodes; ++place) {
        NodeState& state = states_[block][place];
        if (!state.near) {
            continue;
        }
        const Node node = Lattice::node_at(blocks_[block], place);
        Fan fan{lattice_.at(node)};
        std::array<int, Fan::kMostSegments> step{};
        for (int k = 0; k < 7; ++k) {
            const Node other = node + Lattice::steps()[static_cast<std::size_t>(k)];
            const NodeState* its = lattice_.contains(other) ? find(other) : nullptr;
            if (its != nullptr && its->near) {
                step[fan.count] = k;
                fan.to[fan.count++] = lattice_.at(other);
            }
        }
        const unsigned met = surface_.met_of(fan);
        for (std::size_t i = 0; i < fan.count; ++i) {
            state.barred = static_cast<std::uint8_t>(state.barred | (met >> i & 1U) << step[i]);
        }
    }
}

void NodeStates::move(const Node& node, const Vec3& place) {
    find(node)->moved = true;
    moved_.insert_or_assign(Lattice::key(node), place);
}

void NodeStates::move_back(const Node& node) {
    find(node)->moved = false;
    moved_.erase(Lattice::key(node));
}

void NodeStates::bar_edges_at(const Node& node) {
    for_each_neighbour(lattice_, node, [&](const Node& other, int step) {
        NodeState* owner = find(step < 7 ? node : other);
        const auto bit = static_cast<std::uint8_t>(1U << (step % 7));
        const bool meets = surface_.meets(position(node), position(other));
        owner->barred = static_cast<std::uint8_t>(meets ? owner->barred | bit : owner->barred & ~bit);
    });
}

bool NodeStates::is_barred(const Node& node, int step) const {
    if (step >= 7) {
        return is_barred(node + Lattice::steps()[static_cast<std::size_t>(step)], step - 7);
    }
    const NodeState* state = find(node);
    return state != nullptr && (state->barred >> step & 1U) != 0;
}

}  // namespace mq::wrap

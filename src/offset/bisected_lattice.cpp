// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/bisected_lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "offset/tuning.h"

namespace mq::offset {

namespace {

/// Half sides of the finest cubes along an axis, at most: three of these are a key.
constexpr std::int64_t kMostAcross = 1 << 21;

}  // namespace

BisectedLattice::BisectedLattice(const Box& box, double side, double finest) {
    std::int64_t units = 1;
    while (side / static_cast<double>(units) > finest && units < kMostAcross) {
        units *= 2;
    }
    std::array<std::int64_t, 3> cubes{};
    for (int i = 0; i < 3; ++i) {
        // The lattice lies at no round place, so that faces of parts seldom lie in its planes.
        origin_[i] = box.low[i] - OffsetTuning::kShift * (1.0 + 0.37 * i) * side;
        cubes[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::ceil((box.high[i] - origin_[i]) / side));
        if (cubes[static_cast<std::size_t>(i)] * units >= kMostAcross) {
            throw InvalidInput("the tolerance is too small for the size of the part: choose a larger one");
        }
    }
    unit_ = side / static_cast<double>(units);
    for (std::int64_t x = 0; x < cubes[0]; ++x) {
        for (std::int64_t y = 0; y < cubes[1]; ++y) {
            for (std::int64_t z = 0; z < cubes[2]; ++z) {
                std::array<std::size_t, 3> axes{0, 1, 2};
                do {
                    Place place{static_cast<std::int32_t>(x * units), static_cast<std::int32_t>(y * units),
                                static_cast<std::int32_t>(z * units)};
                    Cell cell;
                    cell.nodes[0] = node_at(place);
                    for (std::size_t k = 0; k < 3; ++k) {
                        place[axes[k]] += static_cast<std::int32_t>(units);
                        cell.nodes[k + 1] = node_at(place);
                    }
                    add(cell);
                } while (std::next_permutation(axes.begin(), axes.end()));
            }
        }
    }
}

bool BisectedLattice::is_divisible(const Cell& cell) const {
    const Place& a = nodes_[static_cast<std::size_t>(cell.nodes[0])];
    const Place& b = nodes_[static_cast<std::size_t>(cell.nodes[static_cast<std::size_t>(cell.tag)])];
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])}) > 1;
}

void BisectedLattice::divide(std::size_t first) {
    // A cell waits until all that share the edge to be bisected would bisect it, too. They are coarser or equal, so
    // this ends (Maubach 1995, theorem 5.1).
    std::vector<std::size_t> waiting{first};
    while (!waiting.empty()) {
        const std::size_t last = waiting.back();
        if (is_divided(last)) {
            waiting.pop_back();
            continue;
        }
        const auto edge_of = [&](std::size_t k) {
            return pair_key(cells_[k].nodes[0], cells_[k].nodes[static_cast<std::size_t>(cells_[k].tag)]);
        };
        const std::int32_t a = cells_[last].nodes[0];
        const std::int32_t b = cells_[last].nodes[static_cast<std::size_t>(cells_[last].tag)];
        std::vector<std::size_t> around;
        for (const std::int32_t k : cells_at_[static_cast<std::size_t>(a)]) {
            if (has_edge(static_cast<std::size_t>(k), a, b)) {
                around.push_back(static_cast<std::size_t>(k));
            }
        }
        const auto other =
            std::find_if(around.begin(), around.end(), [&](std::size_t k) { return edge_of(k) != edge_of(last); });
        if (other != around.end()) {
            waiting.push_back(*other);
            continue;
        }
        for (const std::size_t k : around) {
            bisect(k);
        }
        waiting.pop_back();
    }
}

bool BisectedLattice::has_edge(std::size_t cell, std::int32_t a, std::int32_t b) const {
    const auto& nodes = cells_[cell].nodes;
    return std::count(nodes.begin(), nodes.end(), a) + std::count(nodes.begin(), nodes.end(), b) == 2;
}

std::int32_t BisectedLattice::node_at(const Place& place) {
    const std::uint64_t key = (static_cast<std::uint64_t>(place[0]) << 42) |
                              (static_cast<std::uint64_t>(place[1]) << 21) | static_cast<std::uint64_t>(place[2]);
    const auto [at, is_new] = numbers_.insert({key, static_cast<std::int32_t>(nodes_.size())});
    if (is_new) {
        nodes_.push_back(place);
        cells_at_.emplace_back();
    }
    return at->second;
}

void BisectedLattice::add(const Cell& cell) {
    for (const std::int32_t node : cell.nodes) {
        cells_at_[static_cast<std::size_t>(node)].push_back(static_cast<std::int32_t>(cells_.size()));
    }
    cells_.push_back(cell);
    divided_.push_back(0);
}

/// (x0 .. xn) with the tag k becomes (x0 .. x(k-1), z, x(k+1) ..) and (x1 .. xk, z, x(k+1) ..), where z is the middle
/// of x0 and xk.
void BisectedLattice::bisect(std::size_t index) {
    const Cell cell = cells_[index];
    divided_[index] = 1;
    for (const std::int32_t node : cell.nodes) {
        std::vector<std::int32_t>& there = cells_at_[static_cast<std::size_t>(node)];
        there.erase(std::find(there.begin(), there.end(), static_cast<std::int32_t>(index)));
    }
    const auto k = static_cast<std::size_t>(cell.tag);
    Place middle = nodes_[static_cast<std::size_t>(cell.nodes[0])];
    for (std::size_t i = 0; i < 3; ++i) {
        middle[i] = (middle[i] + nodes_[static_cast<std::size_t>(cell.nodes[k])][i]) / 2;
    }
    Cell low = cell;
    Cell high = cell;
    low.tag = high.tag = static_cast<std::int8_t>(cell.tag > 1 ? cell.tag - 1 : 3);
    low.nodes[k] = high.nodes[k] = node_at(middle);
    for (std::size_t i = 0; i < k; ++i) {
        high.nodes[i] = cell.nodes[i + 1];
    }
    add(low);
    add(high);
}

}  // namespace mq::offset

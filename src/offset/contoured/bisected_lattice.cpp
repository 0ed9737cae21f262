// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/contoured/bisected_lattice.h"

#include <algorithm>
#include <cmath>

#include "base/key_set.h"
#include "offset/contoured/tuning.h"

namespace mq::offset {

BisectedLattice::BisectedLattice(const Box& box, double side, double finest) : finest_(finest) {
    Vec3 origin;
    std::array<std::uint64_t, 3> cubes{};
    for (int i = 0; i < 3; ++i) {
        // The lattice starts at no round coordinates, so that faces of models seldom lie in its planes.
        origin[i] = box.low[i] - ContouredOffsetTuning::kShift * (1.0 + 0.37 * i) * side;
        cubes[static_cast<std::size_t>(i)] = static_cast<std::uint64_t>(std::ceil((box.high[i] - origin[i]) / side));
    }
    KeyMap<std::int32_t> numbers;
    const auto node_at = [&](const std::array<std::uint64_t, 3>& place) {
        const std::uint64_t key = (place[0] * (cubes[1] + 1) + place[1]) * (cubes[2] + 1) + place[2];
        const auto [at, is_new] = numbers.insert({key, static_cast<std::int32_t>(nodes_.size())});
        return is_new ? add_node(origin + side * Vec3(double(place[0]), double(place[1]), double(place[2])))
                      : at->second;
    };
    for (std::uint64_t x = 0; x < cubes[0]; ++x) {
        for (std::uint64_t y = 0; y < cubes[1]; ++y) {
            for (std::uint64_t z = 0; z < cubes[2]; ++z) {
                std::array<std::size_t, 3> axes{0, 1, 2};
                do {
                    std::array<std::uint64_t, 3> place{x, y, z};
                    Cell cell{};
                    cell[0] = node_at(place);
                    for (std::size_t k = 0; k < 3; ++k) {
                        ++place[axes[k]];
                        cell[k + 1] = node_at(place);
                    }
                    add(cell);
                } while (std::next_permutation(axes.begin(), axes.end()));
            }
        }
    }
}

/// Among edges of equal length the one with the lower node numbers counts as longer.
std::array<std::int32_t, 2> BisectedLattice::longest_edge(const Cell& cell) const {
    constexpr double kSame = 1e-9;  // relative difference of squared lengths that count as equal
    std::array<std::int32_t, 2> longest{-1, -1};
    double most = -1.0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const std::array<std::int32_t, 2> edge{std::min(cell[i], cell[j]), std::max(cell[i], cell[j])};
            const double length = (at(edge[0]) - at(edge[1])).squaredNorm();
            if (length > most * (1.0 + kSame) || (length > most * (1.0 - kSame) && edge < longest)) {
                longest = edge;
                most = length;
            }
        }
    }
    return longest;
}

bool BisectedLattice::is_divisible(const Cell& cell) const {
    const auto [a, b] = longest_edge(cell);
    return (at(a) - at(b)).norm() > finest_;
}

void BisectedLattice::divide(std::size_t first) {
    // A cell waits until its longest edge is the longest one of all cells around that edge. A cell that waits for
    // another one has a shorter longest edge than that one, or one equal within rounding errors, and no cell waits
    // twice: so this terminates.
    std::vector<int> waiting{static_cast<int>(first)};
    while (!waiting.empty()) {
        const auto last = static_cast<std::size_t>(waiting.back());
        if (is_divided(last)) {
            waiting.pop_back();
            continue;
        }
        const std::array<std::int32_t, 2> edge = longest_edge(cells_[last]);
        const std::vector<int> around = undivided_.of({edge[0], edge[1]}, cells_);
        const auto other = std::find_if(around.begin(), around.end(),
                                        [&](int k) { return longest_edge(cell(static_cast<std::size_t>(k))) != edge; });
        if (other != around.end() && std::find(waiting.begin(), waiting.end(), *other) == waiting.end()) {
            waiting.push_back(*other);
        } else {
            divide_edge(edge[0], edge[1], 0.5 * (at(edge[0]) + at(edge[1])));
        }
    }
}

void BisectedLattice::divide_edge(std::int32_t a, std::int32_t b, const Vec3& point) {
    const std::vector<int> around = undivided_.of({a, b}, cells_);
    if (around.empty()) {
        return;
    }
    const std::int32_t middle = add_node(point);
    for (const int k : around) {
        bisect(static_cast<std::size_t>(k), a, b, middle);
    }
}

std::int32_t BisectedLattice::add_node(const Vec3& place) {
    nodes_.push_back(place);
    undivided_.resize(nodes_.size());
    return static_cast<std::int32_t>(nodes_.size() - 1);
}

void BisectedLattice::add(const Cell& cell) {
    undivided_.add(static_cast<int>(cells_.size()), cell);
    cells_.push_back(cell);
    divided_.push_back(0);
}

void BisectedLattice::bisect(std::size_t index, std::int32_t a, std::int32_t b, std::int32_t middle) {
    const Cell cell = cells_[index];
    divided_[index] = 1;
    undivided_.remove(static_cast<int>(index), cell);
    for (const std::int32_t end : {a, b}) {
        Cell half = cell;
        std::replace(half.begin(), half.end(), end, middle);
        add(half);
    }
}

}  // namespace mq::offset

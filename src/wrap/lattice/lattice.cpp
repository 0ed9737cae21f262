// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/lattice/lattice.h"

#include <cmath>

namespace mq::wrap {

Lattice::Lattice(const Box& box, double margin, double side) : side_(side) {
    // Models lie along the axes and at round numbers: a shift by these fractions of a side keeps nodes off their
    // planes.
    const Vec3 shift(0.3819660, 0.2763932, 0.4472136);
    origin_ = box.low - Vec3::Constant(margin) - side * shift;
    const double across = 0.5 * side * kAcross;
    for (int i = 0; i < 3; ++i) {
        blocks_[static_cast<std::size_t>(i)] =
            static_cast<std::int32_t>(std::ceil((box.high[i] + margin - origin_[i]) / across)) + 1;
    }
}

std::array<std::int32_t, 3> Lattice::block_at(std::size_t index) const {
    const auto y = static_cast<std::size_t>(blocks_[1]);
    const auto z = static_cast<std::size_t>(blocks_[2]);
    return {static_cast<std::int32_t>(index / (y * z)), static_cast<std::int32_t>(index / z % y),
            static_cast<std::int32_t>(index % z)};
}

Node Lattice::node_at(const std::array<std::int32_t, 3>& block, int place) {
    const int odd = place / 64;
    return {kAcross * block[0] + 2 * (place / 16 % 4) + odd, kAcross * block[1] + 2 * (place / 4 % 4) + odd,
            kAcross * block[2] + 2 * (place % 4) + odd};
}

const std::array<Node, 14>& Lattice::steps() {
    static const std::array<Node, 14> all{Node{2, 0, 0},   Node{0, 2, 0},  Node{0, 0, 2},    Node{1, 1, 1},
                                          Node{1, 1, -1},  Node{1, -1, 1}, Node{-1, 1, 1},   Node{-2, 0, 0},
                                          Node{0, -2, 0},  Node{0, 0, -2}, Node{-1, -1, -1}, Node{-1, -1, 1},
                                          Node{-1, 1, -1}, Node{1, -1, -1}};
    return all;
}

int Lattice::step_between(const Node& from, const Node& to) {
    const Node step{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    for (int k = 0; k < 14; ++k) {
        if (steps()[static_cast<std::size_t>(k)] == step) {
            return k;
        }
    }
    return -1;
}

}  // namespace mq::wrap

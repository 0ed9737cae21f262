// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "base/vec.h"

namespace mq::triangulate {

inline std::vector<Vec3> random_points(int count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-10.0, 10.0);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back(place(random), place(random), place(random));
    }
    return points;
}

}  // namespace mq::triangulate

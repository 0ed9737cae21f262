// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

inline std::vector<Triangle> random_triangles(std::uint64_t seed, int vertices, int count) {
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> vertex(0, vertices - 1);
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
        triangles.push_back({vertex(random), vertex(random), vertex(random)});
    }
    return triangles;
}

}  // namespace mq::mesh

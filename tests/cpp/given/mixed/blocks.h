// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "given/mixed/mixed_mesh.h"

namespace mq::given {

/// Hexahedra on a grid of I x J x K cells, whose nodes are at `place(i / I, j / J, k / K)`.
inline MixedMesh hexahedra(int I, int J, int K, const std::function<Vec3(double, double, double)>& place) {
    MixedMesh mesh;
    const auto number = [&](int i, int j, int k) { return (i * (J + 1) + j) * (K + 1) + k; };
    for (int i = 0; i <= I; ++i) {
        for (int j = 0; j <= J; ++j) {
            for (int k = 0; k <= K; ++k) {
                mesh.nodes.push_back(
                    place(static_cast<double>(i) / I, static_cast<double>(j) / J, static_cast<double>(k) / K));
            }
        }
    }
    for (int i = 0; i < I; ++i) {
        for (int j = 0; j < J; ++j) {
            for (int k = 0; k < K; ++k) {
                mesh.elements.push_back({elements::ElementKind::Hexahedron,
                                         {number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k),
                                          number(i, j + 1, k), number(i, j, k + 1), number(i + 1, j, k + 1),
                                          number(i + 1, j + 1, k + 1), number(i, j + 1, k + 1)},
                                         0});
            }
        }
    }
    return mesh;
}

inline MixedMesh cubes(int I, int J, int K) {
    return hexahedra(I, J, K, [&](double x, double y, double z) { return Vec3(I * x, J * y, K * z); });
}

}  // namespace mq::given

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "elements/bezier/bernstein.h"

/// Elements with known maps, to test against.
namespace mq::curve {

/// Nodes of the element of the lattice's order on the reference simplex, moved by `map`.
inline std::vector<Vec3> nodes_of(const elements::Lattice& lattice, const std::function<Vec3(const Vec3&)>& map) {
    std::vector<Vec3> nodes;
    for (int i = 0; i < lattice.size(); ++i) {
        const elements::Barycentric b = lattice.node(i);
        nodes.push_back(map(Vec3(b[1], b[2], b[3])));
    }
    return nodes;
}

inline Vec3 identity(const Vec3& x) {
    return x;
}

/// A point inside a simplex, uniform enough.
inline elements::Barycentric random_point(int dimension, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    elements::Barycentric b{};
    double sum = 0.0;
    for (std::size_t k = 0; k <= static_cast<std::size_t>(dimension); ++k) {
        b[k] = -std::log(uniform(random) + 1e-300);
        sum += b[k];
    }
    for (double& part : b) {
        part /= sum;
    }
    return b;
}

inline std::vector<Vec3> perturbed(std::vector<Vec3> nodes, double size, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-size, size);
    for (Vec3& node : nodes) {
        node += Vec3(uniform(random), uniform(random), uniform(random));
    }
    return nodes;
}

}  // namespace mq::curve

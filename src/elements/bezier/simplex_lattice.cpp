// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/simplex_lattice.h"

#include "base/error.h"
#include "base/memory/never_destroyed.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::elements {

namespace {

double factorial(int n) {
    double product = 1.0;
    for (int i = 2; i <= n; ++i) {
        product *= i;
    }
    return product;
}

std::vector<Lattice> all_lattices() {
    std::vector<Lattice> all;
    for (int dimension = 1; dimension <= 3; ++dimension) {
        for (int degree = 0; degree <= kMaxDegree; ++degree) {
            all.emplace_back(dimension, degree);
        }
    }
    return all;
}

}  // namespace

Lattice::Lattice(int dimension, int degree) : dimension_(dimension), degree_(degree) {
    const std::size_t side = static_cast<std::size_t>(degree) + 1;
    index_.assign(side * side * side, -1);
    const int most2 = dimension >= 2 ? degree : 0;
    const int most3 = dimension >= 3 ? degree : 0;
    for (int k = 0; k <= most3; ++k) {
        for (int j = 0; j <= most2 - k || (j == 0 && k == 0); ++j) {
            for (int i = 0; i <= degree - j - k; ++i) {
                const Exponents e{degree - i - j - k, i, j, k};
                index_[static_cast<std::size_t>(slot(e))] = size();
                points_.push_back(e);
                double rest = factorial(degree);
                for (const int part : e) {
                    rest /= factorial(part);
                }
                multinomials_.push_back(rest);
            }
        }
    }
    for (int k = 0; k <= dimension; ++k) {
        Exponents e{0, 0, 0, 0};
        e[static_cast<std::size_t>(k)] = degree;
        corners_[static_cast<std::size_t>(k)] = index(e);
    }
}

const Lattice& Lattice::of(int dimension, int degree) {
    static const auto& all = never_destroyed(all_lattices());
    if (dimension < 1 || dimension > 3 || degree < 0 || degree > kMaxDegree) {
        throw InvalidInput(phrases::kNoPolynomials, {{"count", degree}, {"count2", dimension}, {"count3", kMaxDegree}});
    }
    return all[static_cast<std::size_t>((dimension - 1) * (kMaxDegree + 1) + degree)];
}

Barycentric Lattice::node(int i) const {
    Barycentric b{};
    for (std::size_t k = 0; k < 4; ++k) {
        b[k] = degree_ > 0 ? static_cast<double>(exponents(i)[k]) / degree_ : 1.0 / (dimension_ + 1);
    }
    return b;
}

int Lattice::carriers(int i) const {
    int count = 0;
    for (const int part : exponents(i)) {
        count += part > 0 ? 1 : 0;
    }
    return count;
}

}  // namespace mq::elements

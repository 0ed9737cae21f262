// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/jacobian_batch.h"

#include <algorithm>

namespace mq::curve {

using elements::Lattice;
using elements::ProductTable;

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

void clear(std::vector<LaneVector>& vectors) {
    std::fill(vectors.begin(), vectors.end(), LaneVector());
}

}  // namespace

JacobianBatch::JacobianBatch(const Lattice& lattice)
    : control(at(lattice.size())),
      coefficients(at(Lattice::of(3, 3 * (lattice.degree() - 1)).size())),
      degree_(lattice.degree()),
      first_(product(degree_ - 1, degree_ - 1)),
      second_(product(degree_ - 1, 2 * (degree_ - 1))),
      crosses_(at(Lattice::of(3, 2 * (degree_ - 1)).size())),
      by_cross_(crosses_.size()) {
    const Lattice& lower = Lattice::of(3, degree_ - 1);
    for (std::size_t k = 0; k < 3; ++k) {
        for (int i = 0; i < lower.size(); ++i) {
            elements::Exponents to = lower.exponents(i);
            elements::Exponents from = to;
            ++to[k + 1];
            ++from[0];
            ends_[k].emplace_back(at(lattice.index(to)), at(lattice.index(from)));
        }
        derivatives_[k].resize(at(lower.size()));
    }
    by_derivatives_ = derivatives_;
}

std::vector<JacobianBatch::Term> JacobianBatch::product(int m, int n) {
    const ProductTable& table = ProductTable::of(3, m, n);
    std::vector<Term> terms;
    for (int i = 0; i < Lattice::of(3, m).size(); ++i) {
        for (int j = 0; j < Lattice::of(3, n).size(); ++j) {
            const ProductTable::Entry& entry = table.at(i, j);
            terms.push_back({i, j, entry.target, entry.weight});
        }
    }
    return terms;
}

void JacobianBatch::evaluate() {
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < ends_[k].size(); ++i) {
            const LaneVector& to = control[ends_[k][i].first];
            const LaneVector& from = control[ends_[k][i].second];
            derivatives_[k][i] = {degree_ * (to.x - from.x), degree_ * (to.y - from.y), degree_ * (to.z - from.z)};
        }
    }
    clear(crosses_);
    std::fill(coefficients.begin(), coefficients.end(), Lanes::Zero());
    for (const Term& e : first_) {
        crosses_[at(e.target)].add_cross(e.weight, derivatives_[1][at(e.i)], derivatives_[2][at(e.j)]);
    }
    for (const Term& e : second_) {
        coefficients[at(e.target)] += e.weight * derivatives_[0][at(e.i)].dot(crosses_[at(e.j)]);
    }
}

void JacobianBatch::differentiate_sum(const std::vector<Lanes>& weights, std::vector<LaneVector>& by_control) {
    for (auto& d : by_derivatives_) {
        clear(d);
    }
    clear(by_cross_);
    for (const Term& e : second_) {
        const Lanes w = weights[at(e.target)] * e.weight;
        by_derivatives_[0][at(e.i)].add(w, crosses_[at(e.j)]);
        by_cross_[at(e.j)].add(w, derivatives_[0][at(e.i)]);
    }
    for (const Term& e : first_) {
        const LaneVector& g = by_cross_[at(e.target)];
        by_derivatives_[1][at(e.i)].add_cross(e.weight, derivatives_[2][at(e.j)], g);
        by_derivatives_[2][at(e.j)].add_cross(e.weight, g, derivatives_[1][at(e.i)]);
    }
    by_control.resize(control.size());
    clear(by_control);
    const Lanes plus = Lanes::Constant(degree_);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < ends_[k].size(); ++i) {
            by_control[ends_[k][i].first].add(plus, by_derivatives_[k][i]);
            by_control[ends_[k][i].second].add(-plus, by_derivatives_[k][i]);
        }
    }
}

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/product_lattice.h"

#include <algorithm>

#include "base/memory/never_destroyed.h"
#include "elements/bezier/bernstein.h"

namespace mq::elements {

namespace {

std::vector<ProductLattice> all_simplices() {
    std::vector<ProductLattice> all;
    for (int dimension = 1; dimension <= 3; ++dimension) {
        for (int degree = 0; degree <= kMaxDegree; ++degree) {
            all.push_back(ProductLattice({{dimension, degree}}));
        }
    }
    return all;
}

}  // namespace

ProductLattice::ProductLattice(std::vector<Factor> factors) {
    for (const Factor& f : factors) {
        factors_.push_back(&Lattice::of(f.dimension, f.degree));
        size_ *= factors_.back()->size();
    }
    corner_of_factors_.push_back({});
    for (std::size_t f = 0; f < factors_.size(); ++f) {
        std::vector<Indices> longer;
        for (const Indices& before : corner_of_factors_) {
            for (int k = 0; k <= factors_[f]->dimension(); ++k) {
                longer.push_back(before);
                longer.back()[f] = k;
            }
        }
        corner_of_factors_ = std::move(longer);
    }
    for (const Indices& corner : corner_of_factors_) {
        Indices at{};
        for (std::size_t f = 0; f < factors_.size(); ++f) {
            at[f] = factors_[f]->corner(corner[f]);
        }
        corners_.push_back(index(at));
    }
}

const ProductLattice& ProductLattice::simplex(int dimension, int degree) {
    static const auto& all = never_destroyed(all_simplices());
    return all[static_cast<std::size_t>((dimension - 1) * (kMaxDegree + 1) + degree)];
}

std::vector<ProductLattice::Factor> ProductLattice::lowered(int f) const {
    std::vector<Factor> result;
    for (int k = 0; k < factors(); ++k) {
        result.push_back({factor(k).dimension(), factor(k).degree() - (k == f ? 1 : 0)});
    }
    return result;
}

ProductLattice ProductLattice::times(const ProductLattice& other) const {
    std::vector<Factor> result;
    for (int f = 0; f < factors(); ++f) {
        result.push_back({factor(f).dimension(), factor(f).degree() + other.factor(f).degree()});
    }
    return ProductLattice(std::move(result));
}

int ProductLattice::index(const Indices& of_factors) const {
    int i = 0;
    for (std::size_t f = 0; f < factors_.size(); ++f) {
        i = i * factors_[f]->size() + of_factors[f];
    }
    return i;
}

ProductLattice::Indices ProductLattice::indices(int i) const {
    Indices result{};
    for (std::size_t f = factors_.size(); f-- > 0;) {
        result[f] = i % factors_[f]->size();
        i /= factors_[f]->size();
    }
    return result;
}

double ProductLattice::multinomial(int i) const {
    const Indices at = indices(i);
    double product = 1.0;
    for (std::size_t f = 0; f < factors_.size(); ++f) {
        product *= factors_[f]->multinomial(at[f]);
    }
    return product;
}

int ProductLattice::index_of_sum(int i, const ProductLattice& other, int j, const ProductLattice& product) const {
    const Indices here = indices(i);
    const Indices there = other.indices(j);
    Indices at{};
    for (std::size_t f = 0; f < factors_.size(); ++f) {
        Exponents sum = factors_[f]->exponents(here[f]);
        for (std::size_t k = 0; k < 4; ++k) {
            sum[k] += other.factors_[f]->exponents(there[f])[k];
        }
        at[f] = product.factors_[f]->index(sum);
    }
    return product.index(at);
}

int ProductLattice::highest_degree() const {
    int highest = 0;
    for (const Lattice* f : factors_) {
        highest = std::max(highest, f->degree());
    }
    return highest;
}

std::pair<std::vector<double>, std::vector<double>> ProductLattice::halve(const std::vector<double>& c, int f, int a,
                                                                          int b) const {
    std::size_t width = 1;
    for (int k = f + 1; k < factors(); ++k) {
        width *= static_cast<std::size_t>(factor(k).size());
    }
    std::pair<std::vector<double>, std::vector<double>> halves{std::vector<double>(c.size()),
                                                               std::vector<double>(c.size())};
    halve_blocks(factor(f), c.size() / width / static_cast<std::size_t>(factor(f).size()), width, c.data(), a, b,
                 halves.first.data(), halves.second.data());
    return halves;
}

}  // namespace mq::elements

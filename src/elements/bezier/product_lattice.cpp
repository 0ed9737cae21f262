// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/product_lattice.h"

#include <algorithm>

#include "base/memory/never_destroyed.h"

namespace mq::curve {

namespace {

/// The lattice of a factor. Lines need degrees beyond those of simplices: the Jacobian of a hexahedron of order 5 has
/// degree 14 along each axis.
const Lattice& lattice_of(const ProductLattice::Factor& factor) {
    static const auto& lines = never_destroyed([] {
        std::vector<Lattice> all;
        for (int degree = 0; degree < 3 * kMaxOrder; ++degree) {
            all.emplace_back(1, degree);
        }
        return all;
    }());
    return factor.dimension == 1 ? lines.at(static_cast<std::size_t>(factor.degree))
                                 : Lattice::of(factor.dimension, factor.degree);
}

/// Rows of points of a lattice that differ by moves from corner a to corner b: each is a polynomial in one variable.
std::vector<std::vector<int>> rows_along(const Lattice& lattice, int a, int b) {
    const auto from = static_cast<std::size_t>(a);
    const auto to = static_cast<std::size_t>(b);
    std::vector<std::vector<int>> rows;
    for (int i = 0; i < lattice.size(); ++i) {
        Exponents e = lattice.exponents(i);
        if (e[to] != 0) {
            continue;
        }
        std::vector<int> row{i};
        while (e[from] > 0) {
            --e[from];
            ++e[to];
            row.push_back(lattice.index(e));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// De Casteljau's algorithm at 1/2 on a row of blocks of `width` numbers, which lie at `at` in the three lists.
void halve_row(const double* c, const std::vector<int>& at, std::size_t width, std::vector<double>& row, double* first,
               double* second) {
    const std::size_t degree = at.size() - 1;
    row.resize(at.size() * width);
    for (std::size_t k = 0; k <= degree; ++k) {
        std::copy_n(c + static_cast<std::size_t>(at[k]) * width, width, row.data() + k * width);
    }
    for (std::size_t step = 0; step <= degree; ++step) {
        const std::size_t left = degree - step;
        std::copy_n(row.data(), width, first + static_cast<std::size_t>(at[step]) * width);
        std::copy_n(row.data() + left * width, width, second + static_cast<std::size_t>(at[left]) * width);
        for (std::size_t x = 0; x < left * width; ++x) {
            row[x] = 0.5 * (row[x] + row[x + width]);
        }
    }
}

}  // namespace

ProductLattice::ProductLattice(std::vector<Factor> factors) {
    for (const Factor& f : factors) {
        factors_.push_back(&lattice_of(f));
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
    const std::size_t block = width * static_cast<std::size_t>(factor(f).size());
    const std::vector<std::vector<int>> rows = rows_along(factor(f), a, b);
    std::pair<std::vector<double>, std::vector<double>> halves{std::vector<double>(c.size()),
                                                               std::vector<double>(c.size())};
    std::vector<double> row;
    for (std::size_t start = 0; start < c.size(); start += block) {
        for (const std::vector<int>& at : rows) {
            halve_row(c.data() + start, at, width, row, halves.first.data() + start, halves.second.data() + start);
        }
    }
    return halves;
}

}  // namespace mq::curve

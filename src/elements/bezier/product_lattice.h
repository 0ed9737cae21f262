// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "elements/bezier/simplex_lattice.h"
#include "elements/bezier/sub_simplex.h"

namespace mq::elements {

/// Polynomials on a product of simplices, of a degree of its own on each: two lines make a square, a triangle and a
/// line a prism. Their Bernstein polynomials are the products of those of the factors, so that the hull of the
/// coefficients bounds them as on a simplex. The index of the last factor runs fastest.
class ProductLattice {
  public:
    struct Factor {
        int dimension;
        int degree;
    };
    /// Indices of a point in the lattices of the factors; those past the factors are 0.
    using Indices = std::array<int, 3>;

    explicit ProductLattice(std::vector<Factor> factors);
    /// The lattice on one simplex, from a table.
    static const ProductLattice& simplex(int dimension, int degree);

    int factors() const { return static_cast<int>(factors_.size()); }
    const Lattice& factor(int f) const { return *factors_[static_cast<std::size_t>(f)]; }
    /// The factors of a lattice whose degree on factor `f` is lower by one.
    std::vector<Factor> lowered(int f) const;
    /// The lattice of products of polynomials of this one and another.
    ProductLattice times(const ProductLattice& other) const;

    int size() const { return size_; }
    int index(const Indices& of_factors) const;
    Indices indices(int i) const;
    /// The factor of the Bernstein polynomial of point i.
    double multinomial(int i) const;
    /// The index of the point whose exponents are the sums of those of point i here and point j of `other`; `product`
    /// is `times(other)`.
    int index_of_sum(int i, const ProductLattice& other, int j, const ProductLattice& product) const;

    /// The corners of the domain, and which corner of each factor they are.
    const std::vector<int>& corners() const { return corners_; }
    const Indices& corner_of_factors(int k) const { return corner_of_factors_[static_cast<std::size_t>(k)]; }
    /// The largest degree on a factor: halving makes each coefficient by at most this number of means, one after
    /// another.
    int highest_degree() const;

    /// The coefficients on the two halves that the middle of edge (a, b) of factor `f` makes.
    std::pair<std::vector<double>, std::vector<double>> halve(const std::vector<double>& c, int f, int a, int b) const;

  private:
    std::vector<const Lattice*> factors_;
    int size_ = 1;
    std::vector<int> corners_;
    std::vector<Indices> corner_of_factors_;
};

/// A piece of a product of simplices: one of each.
using ProductPart = std::array<SimplexPart, 3>;
/// A point of a product of simplices.
using ProductPoint = std::array<Barycentric, 3>;

}  // namespace mq::elements

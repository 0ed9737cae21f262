// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <vector>

#include "elements/bezier/product_lattice.h"

namespace mq::elements {

double largest_magnitude(const std::vector<double>& coefficients);

/// Bounds of the minimum of a Bernstein polynomial: its coefficients bound it from below, its values at the corners of
/// pieces from above, and the piece with the lowest bound is halved, across the longest edge of all its factors.
class MinimumSearch {
  public:
    /// @param rounding  bound of the error of the coefficients
    MinimumSearch(const ProductLattice& lattice, double rounding, std::vector<double> coefficients);

    double low() const { return heap_.front().low; }
    /// The least value that was computed, plus a bound of its rounding error.
    double high() const { return high_; }
    double high_bound() const { return high_ + rounding_ + halvings_ * halving_rounding_; }
    const ProductPoint& at() const { return at_; }
    int pieces() const { return serial_; }

    void step();

  private:
    struct Piece {
        double low;
        int serial;  // ties go to the older piece, so that the order is fixed
        int halvings;
        std::vector<double> coefficients;
        ProductPart part;

        bool operator<(const Piece& other) const { return low != other.low ? low > other.low : serial > other.serial; }
    };

    void push(Piece piece);

    const ProductLattice& lattice_;
    double rounding_;
    /// Bound of the error that one halving adds to a coefficient: it is made by as many means as the highest degree,
    /// each of two numbers and rounded by half a unit in the last place.
    double halving_rounding_;
    int serial_ = 0;
    double high_ = std::numeric_limits<double>::infinity();
    int halvings_ = 0;  // halvings that led to the piece in which `high_` was found
    ProductPoint at_{};
    std::vector<Piece> heap_;  // the piece with the lowest bound is in front
};

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace mq::curve {

inline double largest_magnitude(const std::vector<double>& coefficients) {
    double most = 0.0;
    for (const double c : coefficients) {
        most = std::max(most, std::abs(c));
    }
    return most;
}

/// Bound of the error that one halving adds to each coefficient of a polynomial of this degree: each is the mean of two
/// numbers up to `degree` times, each time rounded by half a unit in the last place.
inline double halving_error(int degree, const std::vector<double>& coefficients) {
    return 0.5 * degree * std::numeric_limits<double>::epsilon() * largest_magnitude(coefficients);
}

/// Bounds of the minimum of a Bernstein polynomial: its coefficients bound it from below, its values at the corners of
/// pieces from above, and the piece with the lowest bound is halved.
///
/// Domain is what the polynomial lives on. It has
/// - `Part`, a piece of it, and `whole()`, all of it;
/// - `corners()`, `corner(k)`, the coefficient that is the value at corner k, and `place(part, k)`, where that is;
/// - `halve(coefficients, part)`, the two halves, as pairs of coefficients and part;
/// - `rounding()`, a bound of the error of the coefficients, and `halving_rounding()`, what one halving adds.
template <typename Domain>
class MinimumSearch {
  public:
    using Part = typename Domain::Part;
    using Place = decltype(std::declval<const Domain&>().place(std::declval<const Part&>(), 0));

    MinimumSearch(const Domain& domain, std::vector<double> coefficients) : domain_(domain) {
        push({0.0, 0, 0, std::move(coefficients), domain.whole()});
    }

    double low() const { return heap_.front().low; }
    /// The least value that was computed, plus a bound of its rounding error.
    double high() const { return high_; }
    double high_bound() const { return high_ + domain_.rounding() + halvings_ * domain_.halving_rounding(); }
    const Place& at() const { return at_; }
    int pieces() const { return serial_; }

    void step() {
        std::pop_heap(heap_.begin(), heap_.end());
        const Piece piece = std::move(heap_.back());
        heap_.pop_back();
        auto [first, second] = domain_.halve(piece.coefficients, piece.part);
        push({0.0, 0, piece.halvings + 1, std::move(first.first), first.second});
        push({0.0, 0, piece.halvings + 1, std::move(second.first), second.second});
    }

  private:
    struct Piece {
        double low;
        int serial;  // ties go to the older piece, so that the order is fixed
        int halvings;
        std::vector<double> coefficients;
        Part part;

        bool operator<(const Piece& other) const { return low != other.low ? low > other.low : serial > other.serial; }
    };

    void push(Piece piece) {
        piece.serial = serial_++;
        piece.low = *std::min_element(piece.coefficients.begin(), piece.coefficients.end()) - domain_.rounding() -
                    piece.halvings * domain_.halving_rounding();
        for (int k = 0; k < domain_.corners(); ++k) {
            const double at_corner = piece.coefficients[static_cast<std::size_t>(domain_.corner(k))];
            if (at_corner < high_) {
                high_ = at_corner;
                at_ = domain_.place(piece.part, k);
                halvings_ = piece.halvings;
            }
        }
        // The minimum cannot be in it; the piece in which `high_` is attained stays.
        if (piece.low > high_) {
            return;
        }
        heap_.push_back(std::move(piece));
        std::push_heap(heap_.begin(), heap_.end());
    }

    const Domain& domain_;
    int serial_ = 0;
    double high_ = std::numeric_limits<double>::infinity();
    int halvings_ = 0;  // halvings that led to the piece in which `high_` was found
    Place at_{};
    std::vector<Piece> heap_;  // the piece with the lowest bound is in front
};

}  // namespace mq::curve

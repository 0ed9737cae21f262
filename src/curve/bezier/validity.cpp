// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/bezier/validity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "curve/bezier/sub_simplex.h"

namespace mq::curve {

namespace {

struct Piece {
    double low = 0.0;
    int serial = 0;  // ties go to the older piece, so that the order is fixed
    std::vector<double> coefficients;
    SimplexPart part = kWholeSimplex;

    bool operator<(const Piece& other) const { return low != other.low ? low > other.low : serial > other.serial; }
};

class Search {
  public:
    explicit Search(const JacobianForm& form) : form_(form), dimension_(form.lattice->dimension()) {
        Piece whole;
        whole.coefficients = form.coefficients;
        best_.high = std::numeric_limits<double>::infinity();
        push(std::move(whole));
    }

    double low() const { return queue_.top().low - form_.rounding; }
    double high() const { return best_.high; }
    int pieces() const { return serial_; }

    /// Halves the piece with the lowest bound across its longest edge.
    void step() {
        const Piece piece = queue_.top();
        queue_.pop();
        const auto [a, b] = longest_edge(piece.part, dimension_);
        auto [first, second] = halve(*form_.lattice, piece.coefficients, a, b);
        const auto [first_part, second_part] = halve(piece.part, a, b);
        push({0.0, 0, std::move(first), first_part});
        push({0.0, 0, std::move(second), second_part});
    }

    Minimum result() const {
        Minimum minimum = best_;
        minimum.low = low();
        minimum.pieces = serial_;
        return minimum;
    }

  private:
    void push(Piece piece) {
        piece.serial = serial_++;
        piece.low = *std::min_element(piece.coefficients.begin(), piece.coefficients.end());
        for (int k = 0; k <= dimension_; ++k) {
            const double at_corner = piece.coefficients[static_cast<std::size_t>(form_.lattice->corner(k))];
            if (at_corner < best_.high) {
                best_.high = at_corner;
                best_.at = piece.part[static_cast<std::size_t>(k)];
            }
        }
        queue_.push(std::move(piece));
    }

    const JacobianForm& form_;
    int dimension_;
    int serial_ = 0;
    Minimum best_;
    std::priority_queue<Piece> queue_;
};

/// Where all coefficients are within the accuracy there is nothing to halve; most elements of a mesh end here.
bool at_once(const JacobianForm& form, double accuracy, Minimum& minimum) {
    const auto least = std::min_element(form.coefficients.begin(), form.coefficients.end());
    minimum.low = *least - form.rounding;
    minimum.high = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= form.lattice->dimension(); ++k) {
        const double at_corner = form.coefficients[static_cast<std::size_t>(form.lattice->corner(k))];
        if (at_corner < minimum.high) {
            minimum.high = at_corner;
            minimum.at = {};
            minimum.at[static_cast<std::size_t>(k)] = 1.0;
        }
    }
    return minimum.high - minimum.low <= accuracy;
}

double largest(const JacobianForm& form) {
    double most = 0.0;
    for (const double c : form.coefficients) {
        most = std::max(most, std::abs(c));
    }
    return most;
}

}  // namespace

Minimum bound_minimum(const JacobianForm& form, double accuracy, int max_pieces) {
    Minimum minimum;
    const double least = std::max(accuracy, 4.0 * form.rounding);
    if (at_once(form, least, minimum)) {
        return minimum;
    }
    Search search(form);
    while (search.high() - search.low() > least && search.pieces() < max_pieces) {
        search.step();
    }
    return search.result();
}

Validity check_positive(const JacobianForm& form) {
    // Simplices at most, so that the search ends where the minimum is nearly zero.
    constexpr int kMaxPieces = 40000;
    Validity validity;
    at_once(form, 0.0, validity.minimum);
    if (validity.minimum.low > 0.0) {
        validity.valid = true;
        return validity;
    }
    // A NaN is a corner value that is not positive.
    if (!(validity.minimum.high > form.rounding)) {
        return validity;
    }
    const double tolerance = kValidityTolerance * largest(form);
    Search search(form);
    while (search.low() <= 0.0 && search.high() > form.rounding && search.pieces() < kMaxPieces &&
           search.high() > tolerance) {
        search.step();
    }
    validity.minimum = search.result();
    validity.valid = validity.minimum.low > 0.0;
    validity.proven = validity.valid || validity.minimum.high <= form.rounding;
    return validity;
}

double certified_ratio(const JacobianForm& form) {
    // Accuracy of the ratio, relative to the largest coefficient.
    constexpr double kAccuracy = 0.02;
    const double scale = largest(form);
    if (!(scale > 0.0)) {
        return -1.0;
    }
    const Minimum minimum = bound_minimum(form, kAccuracy * scale);
    if (minimum.low > 0.0) {
        return minimum.low / scale;
    }
    const Validity verdict = check_positive(form);
    const double least = std::numeric_limits<double>::min();
    return verdict.valid ? std::max(verdict.minimum.low / scale, least) : std::min(minimum.high / scale, -least);
}

Quality quality_of(const JacobianForm& form, double straight) {
    const double scale = largest(form);
    JacobianForm negative = form;
    for (double& c : negative.coefficients) {
        c = -c;
    }
    const double low = bound_minimum(form, kQualityAccuracy * scale).low;
    const double high = -bound_minimum(negative, kQualityAccuracy * scale).low;
    Quality quality;
    quality.distortion = high > 0.0 ? low / high : low / std::max(scale, 1e-300);
    quality.scaled_jacobian = straight != 0.0 ? low / std::abs(straight) : -1.0;
    return quality;
}

}  // namespace mq::curve

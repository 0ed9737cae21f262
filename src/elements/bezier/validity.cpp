// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/validity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elements/bezier/minimum_search.h"
#include "elements/bezier/sub_simplex.h"

namespace mq::curve {

namespace {

/// A simplex for MinimumSearch, halved across the longest edge of each piece.
class SimplexDomain {
  public:
    using Part = SimplexPart;

    explicit SimplexDomain(const JacobianForm& form)
        : lattice_(*form.lattice),
          rounding_(form.rounding),
          halving_rounding_(halving_error(form.lattice->degree(), form.coefficients)) {}

    Part whole() const { return kWholeSimplex; }
    int corners() const { return lattice_.dimension() + 1; }
    int corner(int k) const { return lattice_.corner(k); }
    Barycentric place(const Part& part, int k) const { return part[static_cast<std::size_t>(k)]; }
    double rounding() const { return rounding_; }
    double halving_rounding() const { return halving_rounding_; }

    using Half = std::pair<std::vector<double>, Part>;
    std::pair<Half, Half> halve(const std::vector<double>& coefficients, const Part& part) const {
        const auto [a, b] = longest_edge(part, lattice_.dimension());
        auto [first, second] = curve::halve(lattice_, coefficients, a, b);
        const auto [first_part, second_part] = curve::halve(part, a, b);
        return {{std::move(first), first_part}, {std::move(second), second_part}};
    }

  private:
    const Lattice& lattice_;
    double rounding_;
    double halving_rounding_;
};

using Search = MinimumSearch<SimplexDomain>;

Minimum result(const Search& search) {
    return {search.low(), search.high(), search.at(), search.pieces()};
}

/// If all coefficients are within the accuracy, no halving is needed; most elements of a mesh end here.
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
    return largest_magnitude(form.coefficients);
}

}  // namespace

Minimum bound_minimum(const JacobianForm& form, double accuracy, int max_pieces) {
    Minimum minimum;
    const double least = std::max(accuracy, 4.0 * form.rounding);
    if (at_once(form, least, minimum)) {
        return minimum;
    }
    const SimplexDomain domain(form);
    Search search(domain, form.coefficients);
    while (search.high() - search.low() > least && search.pieces() < max_pieces) {
        search.step();
    }
    return result(search);
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
    const SimplexDomain domain(form);
    Search search(domain, form.coefficients);
    while (search.low() <= 0.0 && search.high() > form.rounding && search.pieces() < kMaxPieces &&
           search.high() > tolerance) {
        search.step();
    }
    validity.minimum = result(search);
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

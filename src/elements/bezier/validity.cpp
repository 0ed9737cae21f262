// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/validity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elements/bezier/minimum_search.h"

namespace mq::elements {

namespace {

Minimum result(const MinimumSearch& search) {
    return {search.low(), search.high(), search.at()[0], search.pieces()};
}

/// If all coefficients are within the accuracy, no halving is needed; most elements of a mesh end here.
bool at_once(const JacobianForm& form, double accuracy, Minimum& minimum) {
    const auto least = std::min_element(form.coefficients.begin(), form.coefficients.end());
    minimum.low = *least - form.rounding;
    minimum.high = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < form.lattice->corners().size(); ++k) {
        const double at_corner = form.coefficients[static_cast<std::size_t>(form.lattice->corners()[k])];
        if (at_corner < minimum.high) {
            minimum.high = at_corner;
            minimum.at = {};
            minimum.at[k] = 1.0;
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
    MinimumSearch search(*form.lattice, form.rounding, form.coefficients);
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
    MinimumSearch search(*form.lattice, form.rounding, form.coefficients);
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

}  // namespace mq::elements

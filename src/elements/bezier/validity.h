// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "elements/bezier/jacobian.h"

/// The certified test: bounds of a Jacobian by the convex hull of its Bernstein coefficients, narrowed by halving the
/// element where the bound is worst (Dey, O'Bara, Shephard 1999, section 5.2.1; Johnen, Remacle, Geuzaine 2013).
namespace mq::elements {

/// Proven bounds of the minimum of a polynomial on a simplex: low <= min <= high, and `high` is attained at `at`.
struct Minimum {
    double low = 0.0;
    double high = 0.0;
    Barycentric at{};
    int pieces = 1;  ///< number of simplices into which the element was halved
};

/// Halves until high - low is at most `accuracy` or `max_pieces` are used up; the bounds hold either way.
Minimum bound_minimum(const JacobianForm& form, double accuracy, int max_pieces = 4000);

/// Valid: proven positive everywhere. Invalid: not positive at `minimum.at`, or so near zero that the proof fails
/// within the tolerance kValidityTolerance of the largest coefficient. There is no third verdict.
struct Validity {
    bool valid = false;
    bool proven = true;  ///< false: counted as invalid because positivity could not be proven
    Minimum minimum;
};

/// The largest value of the minimum, relative to the largest coefficient, at which positivity need not be proven.
constexpr double kValidityTolerance = 1e-7;

Validity check_positive(const JacobianForm& form);

/// A lower bound of min / max of the form, within 0.02; positive exactly when `check_positive` says valid.
double certified_ratio(const JacobianForm& form);

/// Quality of an element from its Jacobian: distortion I = min J / max J (equation (3)) and scaled Jacobian
/// min J / J of the straight element. Both are lower bounds, within `kQualityAccuracy`.
struct Quality {
    double distortion = 0.0;
    double scaled_jacobian = 0.0;
};

/// Accuracy of Quality, absolute: its values are at most about 1.
constexpr double kQualityAccuracy = 0.01;

/// @param straight J of the straight element.
Quality quality_of(const JacobianForm& form, double straight);

}  // namespace mq::elements

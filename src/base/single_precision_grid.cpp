// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/single_precision_grid.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq {
namespace {

/// Bits between the model's size and the quantum.
constexpr int kQuantumBits = 48;
/// Binary digits of a single-precision number.
constexpr int kSingleBits = 24;
/// The size is between 2^-64 and 2^64: the quantum is a single-precision number then, and polynomials of degree 8, the
/// highest of any predicate, neither over- nor underflow (2^(8 (-64 - 48)) > 2^-1022).
constexpr int kLargestExponent = 64;
/// A model gets a local frame when its largest coordinate exceeds its size this many times: single precision would lose
/// more than two bits to the offset.
constexpr double kFarAway = 4.0;

double largest_coordinate(const Vec3& low, const Vec3& high) {
    return std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
}

/// The exponent of the smallest power of two that is at least `value` > 0.
int exponent_above(double value) {
    int exponent = 0;
    return std::frexp(value, &exponent) == 0.5 ? exponent - 1 : exponent;
}

/// The centre of the box as a multiple of a quarter of its side, so that few of its digits are in use and it is a
/// single-precision number; a multiple of a coarser unit only where single precision has no finer.
Vec3 rounded_center(const Box& box, double largest) {
    const int unit_exponent = std::max(exponent_above(box.largest_side()) - 3, exponent_above(largest) - kSingleBits);
    const double unit = std::ldexp(1.0, unit_exponent);
    return (box.center() / unit).unaryExpr([](double x) { return std::nearbyint(x); }) * unit;
}

double half_diagonal_error(int exponent_of_largest, int digits) {
    return std::sqrt(3.0) * std::ldexp(1.0, exponent_of_largest - digits - 1);
}

}  // namespace

SinglePrecisionGrid::SinglePrecisionGrid(const Box& box) {
    int exponent = 0;
    double rounding_of_part = 0.0;
    if (!box.empty()) {
        const double largest = largest_coordinate(box.low, box.high);
        if (!box.low.allFinite() || !box.high.allFinite() || largest > std::ldexp(1.0, kLargestExponent)) {
            throw InvalidInput(phrases::kFarCoordinates, {{"length", in_mm(std::ldexp(1.0, kLargestExponent), 2)}});
        }
        const double side = box.largest_side();
        if (side > 0.0 && largest > kFarAway * side) {
            origin_ = rounded_center(box, largest);
            rounding_of_part = half_diagonal_error(exponent_above(largest), 52);
        }
        const double local = largest_coordinate(box.low - origin_, box.high - origin_);
        exponent = local > 0.0 ? std::max(exponent_above(local), -kLargestExponent) : 0;
    }
    quantum_ = std::ldexp(1.0, exponent - kQuantumBits);
    // Below 2^exponent two neighbours are 2^(exponent - 24) apart. A distant model is rounded twice more, on the way
    // into the local frame and back: by less than half a unit in the last place each, in double precision.
    resolution_ = half_diagonal_error(exponent, kSingleBits) + rounding_of_part;
}

// Multiples of the quantum below 2^24 quanta are single-precision numbers, and single-precision numbers above are
// multiples of the quantum. So one rounding is enough, and finds the nearest of the numbers that are both.
Vec3 SinglePrecisionGrid::snap(const Vec3& point_of_shape) const {
    const double small = std::ldexp(quantum_, kSingleBits);
    return (point_of_shape - origin_).unaryExpr([&](double x) {
        const double rounded =
            std::abs(x) < small ? std::nearbyint(x / quantum_) * quantum_ : double(static_cast<float>(x));
        return rounded + 0.0;  // no negative zero: equal points have equal bits
    });
}

}  // namespace mq

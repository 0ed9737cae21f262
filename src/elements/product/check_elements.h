// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "elements/product/element_jacobian.h"
#include "elements/product/element_kind.h"

/// Validity of curved elements of any kind, without a CAD model.
namespace mq::elements {

enum class Verdict : std::uint8_t {
    Valid = 0,     ///< proven: J is positive everywhere
    Folded = 1,    ///< J is not positive at some point, up to the bound of rounding, and at least 0 at another point
    Inverted = 2,  ///< proven: J is negative everywhere, the nodes are numbered the wrong way round
    NotProven = 3  ///< neither was proven, which happens where the minimum of J is nearly zero
};

/// Bounds of the distortion I = min J / max |J|, and the verdict that goes with them.
///
/// For valid elements this is min J / max J, equation (3) of Dey, O'Bara, Shephard 1999; one definition for all kinds.
/// It is 1 where J is constant, at most 0 where the element is folded, and -1 where it is inverted.
struct ElementVerdict {
    double low = -1.0;
    double high = 1.0;
    Verdict verdict = Verdict::NotProven;
    ProductPoint at{};  ///< where J was found smallest
};

/// Bounds and verdict of a Jacobian; high - low is at most about `kElementAccuracy` unless that takes too many pieces.
ElementVerdict judge(const JacobianForm& jacobian);

/// Accuracy of the minimum and the maximum of J, relative to the largest |J|.
constexpr double kElementAccuracy = 0.01;

/// By element: bounds of min J / max |J| and a Verdict.
struct ElementVerdicts {
    std::vector<double> low;
    std::vector<double> high;
    std::vector<std::uint8_t> verdict;
};

/// Judges elements of one kind and order.
///
/// Solid elements are valid where J is positive, surface elements where their normal x_r x x_s has a positive component
/// along its mean in the element: those cannot be inverted, as space has no side from which they must be seen.
/// @param connectivity       the nodes of one element after those of the other, from 0, in Gmsh's order
/// @param nodes_per_element  all nodes of the order, or those of a serendipity element
/// @throws InvalidInput where the numbers do not fit together, or a coordinate is not finite
ElementVerdicts check_elements(ElementKind kind, int order, const std::vector<Vec3>& nodes,
                               const std::vector<std::int32_t>& connectivity, int nodes_per_element,
                               Progress* progress = nullptr);

}  // namespace mq::elements

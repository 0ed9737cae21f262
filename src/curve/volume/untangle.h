// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/progress.h"
#include "curve/volume/untangling_patch.h"

namespace mq::curve {

/// Moves the free control points of a patch until every Bernstein coefficient of every Jacobian that they can change is
/// at least `target` times the J that its element is to have (TetrahedralMesh::reference_jacobian), or the elements no
/// longer come nearer to it. Ends sooner where few elements miss the target: smaller patches are made for what is still
/// bad.
///
/// The objective is the sum over the coefficients B (relative to that J) of log^2((B - b) / (1 - b)) + (B
/// - 1)^2, whose barrier b lies below the least coefficient and moves up with it (Toulorge, Geuzaine, Remacle,
/// Lambrechts 2013); minimised by the limited-memory BFGS method. Unlike there each element has its own barrier: an
/// element that cannot become valid does not hold back others, and no valid element becomes invalid. As the
/// coefficients bound the Jacobian, an element whose coefficients end above zero is proven valid.
/// @return the number of Jacobians evaluated, which measures the work.
/// @throws Cancelled
std::size_t untangle(UntanglingPatch& patch, double target, const Progress& progress);

}  // namespace mq::curve

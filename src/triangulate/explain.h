// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "triangulate/corner_force.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// The sentence for the report: why a triangle keeps a small angle, and which CAD entities are the reason.
/// `bound` radians.
std::string explain(const Workspace& work, CornerForce& forces, int triangle, const Exemption& exemption, double bound);

}  // namespace mq::triangulate

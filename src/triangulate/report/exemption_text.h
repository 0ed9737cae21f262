// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "triangulate/report/infeasible_corner.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Returns the sentence for the report: why a triangle keeps a small angle, and which CAD entities cause it. `bound`
/// in radians.
std::string explain(const Workspace& work, InfeasibleCorner& forces, int triangle, const Exemption& exemption,
                    double bound);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/quality/exempt_reason.h"
#include "triangulate/report/infeasible_corner.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Returns for the report why a triangle keeps a small angle, and which CAD entities cause it. `bound` in radians.
mesh::ExemptReason explain(const Workspace& work, InfeasibleCorner& forces, int triangle, const Exemption& exemption,
                           double bound);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/quality/exempt_reason.h"
#include "triangulate/report/infeasible_corner.h"
#include "triangulate/report/joined_corners.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Where corners are looked up for the report.
struct CornersOfReport {
    InfeasibleCorner& infeasible;
    JoinedCorners& joined;
};

/// Returns for the report why a triangle keeps a small angle, and which CAD entities cause it. `bound` in radians.
mesh::ExemptReason explain(const Workspace& work, const CornersOfReport& corners, int triangle,
                           const Exemption& exemption, double bound);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/report.h"
#include "triangulate/findings.h"
#include "triangulate/output.h"
#include "triangulate/triangulate.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Measures the mesh on its way out: angles, distances from the part, self-intersections; names what is missed, and
/// why. `chord` in mm: the tolerance; 0: none. What is in `findings` is not looked for again.
/// @throws Cancelled
mesh::MeshReport final_report(Workspace& work, Findings& findings, const Output& out, const Options& options,
                              double chord);

}  // namespace mq::triangulate

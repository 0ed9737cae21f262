// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/message.h"
#include "triangulate/work_mesh/options.h"
#include "triangulate/work_mesh/size_bounds.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// The last stage of refinement with KeepEdges::Feature: smooth edges left from modelling no longer constrain the
/// mesh. Triangles may span them; vertices that only they required are removed, and with them the needles caused by
/// tiny edges, slivers and cusps between smooth edges. Angles, tolerance and the number of crossings do not become
/// worse.
///
/// Fills `work.spanning`. Afterwards `work.maxmin` does not describe the mesh any more.
/// @return what was done, for the report; empty if the shape has no smooth edges
Message remove_smooth_edges(Workspace& work, const TriangulateOptions& options, const Sizing& sizing);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>

#include "triangulate/chord_height.h"
#include "triangulate/sizing.h"
#include "triangulate/triangulate.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// The last stage of refinement with KeepEdges::Feature: smooth CAD edges, relics of how a part was modelled, let go of
/// the mesh. Triangles may span them; vertices that only they needed go away, and so do the needles that tiny edges,
/// slivers and cusps between smooth edges made. What is left over is no less than before: angles, tolerance, and faces
/// that do not cross.
///
/// Fills `work.spanning`. Afterwards `work.maxmin` does not describe the mesh any more.
/// @return what was done, for the report; empty where the part has no smooth edges
std::string release_relics(Workspace& work, const Options& options, const Sizing& sizing);

/// The largest distance of the triangles in `work.spanning` from the faces near them.
ChordHeight farthest_spanning(Workspace& work);

}  // namespace mq::triangulate

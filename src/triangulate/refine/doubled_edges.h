// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/refine/segment_splitter.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

// A mesh is a simplicial complex only if no two of its edges join the same vertices. Two faces can break this at the
// vertices of their borders, and a face with a seam at the two sides of its seam. Later operations keep it
// (MaxMinSwaps), except for the splits of segments.

/// Splits all segments that join the same nodes but the straightest of them. Changed triangles are appended to
/// `touched`.
void separate_doubled_segments(Workspace& work, SegmentSplitter& splitter, std::vector<int>& touched);

/// Inserts a vertex in the middle of edges that join the same vertices, however short they are: a consistent surface
/// takes precedence over min_edge. Changed triangles are appended to `touched`.
/// @return whether any vertex was inserted
bool separate_doubled_edges(Workspace& work, std::vector<int>& touched);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Whether the vertex opposite to a half-edge in its triangle is inside the sphere whose diameter the half-edge is.
bool apex_encroaches(const ClassifiedMesh& mesh, int half_edge);

/// Removes vertices inside of faces that encroach upon a segment, if the triangles without them follow the surface (as
/// Chew 1993 does whenever a segment is split). A vertex near the chord, or between the chord and its curve, would be
/// arbitrarily close to the pieces of the segment, and the mesh would be graded from there. Refinement inserts no such
/// vertices.
/// Appends changed triangles to `touched`. May leave unused triangle indices: see close_gaps.
void remove_encroaching_vertices(Workspace& work, int segment, std::vector<int>& touched);

/// Removes such vertices at all segments of the initial triangulation. Leaves no unused triangle indices.
void remove_encroaching_vertices(Workspace& work);

}  // namespace mq::triangulate

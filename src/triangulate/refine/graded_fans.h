// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <set>
#include <vector>

#include "triangulate/refine/segment_splitter.h"

namespace mq::triangulate {

/// Writes graded fans beside narrow corners.
///
/// The innermost piece of an edge at a small input angle is long compared with the next piece, which is as short as
/// the corner is wide there. On the face on the other side of the edge, the triangles around the vertex between both
/// pieces keep the bound only as a fan: n triangles with equal angles, in which each spoke is shorter than the last by
/// the same factor. At 25 degrees, seven triangles in a straight angle have room for two pieces with a ratio of 69.
/// Refinement inserts one vertex for one triangle, and finds no such fan, as its vertices encroach on the innermost
/// piece. Here a fan is written down as a whole, in place of all triangles that it overlaps and of all vertices that
/// are too near to its own.
class GradedFans {
  public:
    /// @param bound  of angles, radians
    GradedFans(Workspace& work, const SegmentSplitter& segments, double bound)
        : work_(work), segments_(segments), bound_(bound) {}

    /// Writes a fan around a corner of a triangle below the bound, if an innermost piece ends there, once for each pair
    /// of pieces. Triangles between the fan and the rest of the face may be below the bound, and are to be refined.
    /// Appends changed triangles to `touched`.
    /// @return whether a fan was written. Leaves no unused triangle indices.
    bool write_beside(int triangle, std::vector<int>& touched);
    /// Follows ClassifiedMesh::order_in_space.
    void renumber(const NewIndices& renewed);

  private:
    bool ends_innermost_piece(int segment, int vertex) const;

    Workspace& work_;
    const SegmentSplitter& segments_;
    double bound_;
    std::set<std::array<int, 3>>
        tried_;  // vertices: the one in the middle, and those at the far ends of the two pieces
};

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "mesh/surface_mesh.h"
#include "triangulate/fold.h"
#include "triangulate/triangle_marks.h"

namespace mq::triangulate {

/// Keeps a mesh constrained locally maxmin (Aftosmis 1999, sections 3.3 and 3.4): no legal swap of an edge makes the
/// smallest angle beside it larger.
///
/// A swap is legal when the edge is no segment, the two new triangles do not fold over the surface, and no two edges
/// of the mesh join the same vertices afterwards.
class Maxmin {
  public:
    explicit Maxmin(mesh::SurfaceMesh& mesh);
    /// After the mesh was changed without it.
    void look_again();

    /// Swaps until no edge of the whole mesh violates the predicate, but for those beside the `settled` triangles.
    void sweep(std::vector<int>& touched, const TriangleMarks& settled = {});
    /// Swaps until no edge reachable from `stack` violates it, forward and back: every swap puts the four edges around
    /// it on the stack again. Changed triangles are appended to `touched`. New triangles less aligned with their
    /// surface than `least` make a swap illegal, unless the old ones were worse.
    void restore(std::vector<int>& stack, std::vector<int>& touched, double least = kAlignedSwap);

    /// The same from the edges of the triangles that `touched` holds from `first` on.
    void restore_around(std::size_t first, std::vector<int>& touched);

    /// Swaps the edge of `h` whatever the predicate says, and keeps the books.
    void swap(int h, std::vector<int>& touched);

    /// Other triangles in the place of some (see SurfaceMesh::replace), in the books as well.
    std::vector<int> replace(const std::vector<int>& removed, const std::vector<std::array<int, 3>>& added);
    /// Two segments in the place of one (see SurfaceMesh::split_segment), in the books as well.
    int split_segment(int segment, int vertex, double t, const std::vector<int>& sites);
    /// One segment in the place of two (see SurfaceMesh::join_segments), in the books as well.
    std::vector<int> join_segments(int near, int far, const std::vector<mesh::SurfaceMesh::Refill>& refills);
    /// Another vertex between two segments (see SurfaceMesh::put_between), in the books as well.
    void put_between(int near, int far, int vertex, double t, const std::vector<std::vector<int>>& spokes,
                     const std::vector<int>& sites);
    /// On a CAD edge or at a node.
    bool on_border(int vertex) const { return mesh_.vertex(vertex).entity[0] < 2; }
    /// Whether an edge or a segment joins the two vertices already, both of them on CAD edges.
    bool joined(int a, int b) const { return on_border(a) && on_border(b) && pairs_.count(pair_key(a, b)) > 0; }

    /// Half-edges without a segment that join two vertices that another edge joins already.
    std::vector<int> doubled_edges() const;
    /// To be called before and after a vertex is put on an edge or a segment between two border vertices.
    void forget(int a, int b);
    void remember(int a, int b);

  private:
    bool legal(int h, double least) const;
    void book_inner_edges(const std::vector<int>& triangles, void (Maxmin::*book)(int, int));

    mesh::SurfaceMesh& mesh_;
    std::vector<int> around_;  // of restore_around, whose memory is used again
    // Edges between two vertices on CAD edges: only these can meet the same pair on another face.
    KeyMap<int> pairs_;
    int doubled_ = 0;  // pairs that more than one edge joins
};

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "triangulate/work_mesh/classified_mesh.h"
#include "triangulate/work_mesh/element_marks.h"
#include "triangulate/work_mesh/surface_alignment.h"

namespace mq::triangulate {

/// Keeps a mesh constrained locally maxmin (Aftosmis 1999, sections 3.3 and 3.4): no legal swap of an edge enlarges
/// the smallest angle beside it.
///
/// A swap is legal if the edge is no segment, the two new triangles do not fold over the surface, and no two edges of
/// the mesh join the same vertices afterwards.
class MaxMinSwaps {
  public:
    /// Enters the edges that the mesh has into the table of joined pairs.
    explicit MaxMinSwaps(ClassifiedMesh& mesh);
    /// The swaps of one of several threads that change blocks of the mesh: its table holds what differs from that of
    /// `whole`, which must not change while this object lives, until `adopt`.
    MaxMinSwaps(ClassifiedMesh& mesh, const MaxMinSwaps& whole) : mesh_(mesh), whole_(&whole) {}
    /// Enters the differences of a block into the table. `renamed` gives the present indices of its vertices.
    template <typename Renamed>
    void adopt(const MaxMinSwaps& block, const Renamed& renamed) {
        for (const auto& [key, difference] : block.pairs_) {
            const auto a = renamed(static_cast<std::int32_t>(key >> 32));
            const auto b = renamed(static_cast<std::int32_t>(key & 0xffffffffU));
            for (int n = difference; n > 0; --n) {
                remember(a, b);
            }
            for (int n = difference; n < 0; ++n) {
                forget(a, b);
            }
        }
    }
    /// Enters all pairs of joined vertices again, after the mesh was replaced.
    void rebuild();

    /// Swaps until no edge of the whole mesh violates the predicate, except those beside the `settled` triangles.
    void sweep(std::vector<int>& touched, const TriangleMarks& settled = {});
    /// Swaps until no edge reachable from `stack` violates the predicate, with backtracking: every swap puts the four
    /// edges around it on the stack again. Changed triangles are appended to `touched`. New triangles less aligned
    /// with their surface than `least` make a swap illegal, unless the old ones were worse.
    void restore(std::vector<int>& stack, std::vector<int>& touched, double least = kAlignedSwap);

    /// Likewise from the edges of the triangles that `touched` contains from index `first` on.
    void restore_around(std::size_t first, std::vector<int>& touched);

    /// Swaps the edge of `h` regardless of the predicate, and updates the table of joined pairs.
    void swap(int h, std::vector<int>& touched);

    /// Replaces triangles by others (see ClassifiedMesh::replace), and updates the table of joined pairs.
    std::vector<int> replace(const std::vector<int>& removed, const std::vector<std::array<int, 3>>& added);
    /// Splits a triangle (see ClassifiedMesh::split_triangle), and updates the table of joined pairs.
    std::array<int, 3> split_triangle(int triangle, int site);
    /// Splits a segment (see ClassifiedMesh::split_segment), and updates the table of joined pairs.
    int split_segment(int segment, int vertex, double t, const std::vector<int>& sites);
    /// Joins two segments (see ClassifiedMesh::join_segments), and updates the table of joined pairs.
    std::vector<int> join_segments(int near, int far, const std::vector<ClassifiedMesh::CavityFill>& refills);
    /// Replaces the vertex between two segments (see ClassifiedMesh::replace_between), and updates the table of joined
    /// pairs.
    void replace_between(int near, int far, int vertex, double t, const std::vector<std::vector<int>>& spokes,
                         const std::vector<int>& sites);
    /// Whether the vertex lies on a CAD edge or at a node.
    bool on_border(int vertex) const { return mesh_.vertex(vertex).entity[0] < 2; }
    /// Whether an edge or a segment joins the vertices already, one of which at least lies on a CAD edge.
    bool joined(int a, int b) const { return may_be_doubled(a, b) && edges_between(a, b) > 0; }

    /// Whether another edge joins the same vertices.
    bool is_doubled(int h) const;
    /// Returns half-edges without a segment that join two vertices which another edge joins already.
    std::vector<int> doubled_edges() const;

  private:
    // Two faces meet in vertices on CAD edges only, and so do the two sides of a face at its seam.
    bool may_be_doubled(int a, int b) const { return on_border(a) || on_border(b); }
    int edges_between(int a, int b) const;
    void forget(int a, int b);
    void remember(int a, int b);
    bool legal(int h, double least) const;
    void book_inner_edges(const std::vector<int>& triangles, void (MaxMinSwaps::*book)(int, int));

    ClassifiedMesh& mesh_;
    const MaxMinSwaps* whole_ = nullptr;
    std::vector<int> around_;  // buffer of restore_around, kept to reuse its memory
    // Numbers of edges that join two vertices of which one at least lies on a CAD edge; with `whole_` how many more.
    KeyMap<int> pairs_;
    int doubled_ = 0;  // pairs that more than one edge joins
};

}  // namespace mq::triangulate

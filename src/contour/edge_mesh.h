// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contour/corner_lists.h"
#include "mesh/triangle_mesh.h"

namespace mq::contour {

inline bool has(const mesh::Triangle& t, std::int32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

/// The triangles of a surface with their corners by vertex and with numbers of their edges, while edges collapse.
/// Corner 3 t + k is the k-th one of triangle t. A triangle that is gone has no vertices (-1).
class EdgeMesh {
  public:
    /// @param triangles  which this object changes, and which must outlive it
    EdgeMesh(std::vector<mesh::Triangle>& triangles, std::size_t vertices);

    CornerLists::Range corners_at(std::int32_t v) const { return corners_.at(v); }
    std::size_t edge_count() const { return ends_.size(); }
    const std::array<std::int32_t, 2>& ends(std::int32_t edge) const { return ends_[static_cast<std::size_t>(edge)]; }
    /// The edge of a triangle from corner k on to the next one.
    std::int32_t edge_after(std::int32_t t, int k) const {
        return edges_of_[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
    }
    /// The corner at a of the triangle that runs from there to b; -1: none does.
    std::int32_t corner_of(std::int32_t a, std::int32_t b) const;

    /// Whether the surface stays 2-manifold, and is more than a tetrahedron, if the edge (a, b) collapses: only the
    /// vertices beside it are joined to both of its ends (link condition).
    bool keeps_links(std::int32_t a, std::int32_t b);

    /// What vanishes with an edge, and what is beside it.
    struct Merged {
        std::vector<std::int32_t> edges;     ///< that are gone, but for the edge itself
        std::vector<std::int32_t> vertices;  ///< the third ones of the triangles that are gone
    };
    /// Collapses the edge (a, b): its triangles vanish, and the others at b have a in its place.
    const Merged& merge(std::int32_t a, std::int32_t b);

  private:
    void add_edge(std::int32_t t, int k);
    void remove_triangle(std::int32_t corner, std::int32_t a);

    std::vector<mesh::Triangle>& triangles_;
    CornerLists corners_;
    std::vector<std::array<std::int32_t, 2>> ends_;      ///< by edge
    std::vector<std::array<std::int32_t, 3>> edges_of_;  ///< by triangle: the edge after each of its corners
    std::vector<std::uint32_t> marks_;                   ///< by vertex, for keeps_links
    std::uint32_t next_mark_ = 1;
    Merged merged_;
    std::vector<std::int32_t> gone_;  ///< corners of triangles that vanish
};

}  // namespace mq::contour

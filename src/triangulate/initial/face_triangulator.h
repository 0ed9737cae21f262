// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "triangulate/edges/edge_discretisation.h"
#include "triangulate/initial/constrained_delaunay.h"

namespace mq::triangulate {

/// A coarse triangulation of one face: constrained Delaunay in the metric-scaled parameter domain, refined until no
/// triangle's normal deviates from the surface.
struct FaceMesh {
    /// The use of a vertex by the face; in short, a site.
    struct VertexUse {
        int vertex = -1;  ///< vertex of the chains; -1: a vertex inside the face, at `point`
        Vec2 uv = Vec2::Zero();
        Vec3 normal = Vec3::Zero();
        Vec3 point = Vec3::Zero();
    };
    /// A piece of a CAD edge: piece `index` of the chain of the use's edge.
    struct Border {
        int use = -1;
        int index = -1;
    };
    /// The neighbour of a triangle's side: a half-edge 3 t + i of the same face, or a border.
    struct Link {
        int half_edge = -1;
        int border = -1;
    };
    std::vector<VertexUse> sites;
    std::vector<std::array<int, 3>> triangles;  ///< sites, counter-clockwise seen from outside
    std::vector<std::array<Link, 3>> links;     ///< by triangle, for the side from corner i to corner i + 1
    std::vector<Border> borders;
    std::string failure;  ///< the reason if there is no triangulation, else empty
    std::set<EdgeDiscretisation::PieceRef>
        marks;           ///< pieces of CAD edges to be halved before the face can be triangulated
    int unresolved = 0;  ///< triangles whose normal still deviates from the surface
};

/// Whether two sites are one vertex in space: a pole is one vertex with many sites in (u, v).
inline bool same_vertex(const FaceMesh::VertexUse& a, const FaceMesh::VertexUse& b) {
    return a.vertex >= 0 && a.vertex == b.vertex;
}

/// Triangulates a face over the present chains. If `marks` is not empty in the result, halve these pieces and call
/// again. With `border_may_change`, pieces are also marked where normals of triangles deviate from the surface;
/// without it, only where the border cannot be triangulated otherwise. `inner` sites become vertices too, unless they
/// lie on the border or outside of it in (u, v); this is fast if successive sites are close.
FaceMesh triangulate_face(geometry::Oracle& oracle, const EdgeDiscretisation& chains, const SinglePrecisionGrid& grid,
                          int face, bool border_may_change, const std::vector<FaceMesh::VertexUse>& inner = {});

/// Reverses the orientation of every triangle and keeps the links: for a face whose outward normal is -(Su x Sv).
void reverse_orientation(FaceMesh& face);

}  // namespace mq::triangulate

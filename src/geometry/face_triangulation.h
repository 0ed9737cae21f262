// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "geometry/edge_chains.h"
#include "geometry/planar_triangulation.h"

namespace mq::geometry {

/// A coarse triangulation of one face: constrained Delaunay in the metric-scaled parameter domain, refined until no
/// triangle turns away from the surface.
struct FaceTriangulation {
    struct Site {
        int vertex = -1;  ///< of the chains; -1: a vertex inside the face, at `point`
        Vec2 uv = Vec2::Zero();
        Vec3 normal = Vec3::Zero();
        Vec3 point = Vec3::Zero();
    };
    /// A piece of a CAD edge: piece `index` of the chain of the use's edge.
    struct Border {
        int use = -1;
        int index = -1;
    };
    /// Where a side of a triangle leads: to a half-edge 3 t + i of the same face, or to a border.
    struct Link {
        int half_edge = -1;
        int border = -1;
    };
    std::vector<Site> sites;
    std::vector<std::array<int, 3>> triangles;  ///< sites, counter-clockwise seen from outside
    std::vector<std::array<Link, 3>> links;     ///< of the side from corner i to corner i + 1
    std::vector<Border> borders;
    std::string failure;               ///< why there is no triangulation; empty when there is one
    std::set<EdgeChains::Mark> marks;  ///< pieces of CAD edges that must be halved before the face can be done
    int unresolved = 0;                ///< triangles that still turn away from the surface
};

/// In space: a pole is one vertex with many sites in (u, v).
inline bool same_vertex(const FaceTriangulation::Site& a, const FaceTriangulation::Site& b) {
    return a.vertex >= 0 && a.vertex == b.vertex;
}

/// Triangulates a face over the present chains. When `marks` is not empty in the result, halve them and call again.
/// With `border_may_change` pieces are marked also where triangles turn away from the surface; without it only where
/// the border cannot be triangulated otherwise. `inner` sites become vertices too, unless they lie on the border or
/// outside of it in (u, v); it is fast when near ones follow each other.
FaceTriangulation triangulate_face(Session& session, const EdgeChains& chains, const SingleGrid& grid, int face,
                                   bool border_may_change, const std::vector<FaceTriangulation::Site>& inner = {});

}  // namespace mq::geometry

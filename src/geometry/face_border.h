// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/face_triangulation.h"

namespace mq::geometry {

/// The border of a face as line segments between sites in (u, v), still to be triangulated.
struct FaceBorder {
    struct Piece {
        int from = -1;  ///< sites; walking from one to the other, the face lies on the left
        int to = -1;
        int use = -1;    ///< -1: a gap between the (u, v) images of one vertex
        int index = -1;  ///< piece of the chain; -1 on a collapsed edge or a gap
        bool internal = false;
        int loop = -1;  ///< of the face

        bool collapsed() const { return index < 0; }
    };
    std::vector<FaceTriangulation::Site> sites;
    std::vector<Piece> pieces;
    Vec2 scale = Vec2::Ones();  ///< mm per unit of u and of v, on average
    bool plane = false;
    double deviation = 0.0;  ///< largest distance between an edge's own curve and its curve on the face, mm

    Vec2 scaled(const Vec2& uv) const { return uv.cwiseProduct(scale); }
    Vec2 unscaled(const Vec2& xy) const { return xy.cwiseQuotient(scale); }
};

/// Walks the loops of a face over the chains. Sites are shared where pieces meet in one vertex at one (u, v).
/// On failure `failure` says why.
FaceBorder face_border(Session& session, const EdgeChains& chains, const SingleGrid& grid, int face,
                       std::string& failure);

/// Of the nodes inside the face, with which what touches it there shares a vertex. Those on its border have sites.
std::vector<FaceTriangulation::Site> sites_of_points(Session& session, const EdgeChains& chains, const SingleGrid& grid,
                                                     int face, const FaceBorder& border);

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "triangulate/initial/face_triangulator.h"

namespace mq::triangulate {

/// The border of a face as line segments between sites in (u, v), before triangulation.
struct FaceBoundary {
    struct Piece {
        int from = -1;  ///< sites; from the first to the second, the face lies on the left
        int to = -1;
        int use = -1;    ///< -1: a gap between the (u, v) images of one vertex
        int index = -1;  ///< piece of the chain; -1 on a collapsed edge or a gap
        bool internal = false;
        int loop = -1;  ///< index of the face's loop

        bool collapsed() const { return index < 0; }
    };
    std::vector<FaceMesh::VertexUse> sites;
    std::vector<Piece> pieces;
    std::vector<int> collapsed_run;  ///< by site: the same number for those that collapsed pieces join
    Vec2 scale = Vec2::Ones();       ///< mm per unit of u and of v, on average
    bool plane = false;
    double deviation = 0.0;  ///< largest distance between an edge's own curve and its curve on the face, mm

    Vec2 scaled(const Vec2& uv) const { return uv.cwiseProduct(scale); }
    Vec2 unscaled(const Vec2& xy) const { return xy.cwiseQuotient(scale); }
    /// Sets `collapsed_run`.
    void find_collapsed_runs();
    /// Whether collapsed pieces join two sites, directly or through others.
    bool joined_by_collapsed(int a, int b) const {
        const auto count = static_cast<int>(collapsed_run.size());
        return a < count && b < count && collapsed_run[a] == collapsed_run[b];
    }
};

/// Returns the number of points of all loops of a face, as its edges are divided.
std::size_t points_around(const geometry::Topology& topology, const EdgeDiscretisation& chains, int face);

/// Collects the loops of a face over the chains. Pieces share a site where they meet in one vertex at one (u, v). On
/// failure, `failure` gives the reason.
FaceBoundary face_boundary(geometry::Oracle& oracle, const EdgeDiscretisation& chains, const SinglePrecisionGrid& grid,
                           int face, std::string& failure);

/// Returns by piece the middle of its curve in the scaled domain; nothing for collapsed pieces and where there is none.
std::vector<std::optional<Vec2>> middles_of_pieces(geometry::Oracle& oracle, const EdgeDiscretisation& chains,
                                                   const FaceBoundary& border);

/// Returns sites for the nodes inside the face, through which it shares vertices with entities that touch it. Nodes on
/// the border have sites already.
std::vector<FaceMesh::VertexUse> sites_of_points(geometry::Oracle& oracle, const EdgeDiscretisation& chains,
                                                 const SinglePrecisionGrid& grid, int face, const FaceBoundary& border);

}  // namespace mq::triangulate

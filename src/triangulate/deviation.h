// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "mesh/surface_mesh.h"

/// Where an edge or a triangle is farthest from its surface, as far as its corners and sides tell: there it is
/// measured.
namespace mq::triangulate {

/// Between the ends of an edge the surface is taken for a cubic with the slopes that it has at the ends.
struct EdgePeak {
    double at = 0.5;      ///< part of the way along the half-edge, in steps of a tenth
    double height = 0.0;  ///< mm, at least 0
};
EdgePeak edge_peak(const mesh::SurfaceMesh& mesh, int half_edge);
/// Of an edge that need not be there.
EdgePeak edge_peak(const mesh::SurfaceMesh::Site& from, const mesh::SurfaceMesh::Site& to);

/// How much lower or higher the cubic between two sites is over one half of the way than over the other: over the part
/// x of the way that is skew x (1 - x) (1 - 2 x), mm.
double side_skew(const mesh::SurfaceMesh::Site& from, const mesh::SurfaceMesh::Site& to);

/// Over a triangle the surface is taken for a cubic: a quadratic by its heights over the middles of the sides, and over
/// every side the skew that the slopes at its ends tell.
struct TriangleHeights {
    std::array<double, 3> middles{};  ///< over the side from corner k to k + 1; mm, with sign
    std::array<double, 3> skews{};    ///< of that side, see side_skew

    /// At barycentric weights, mm.
    double at(const std::array<double, 3>& weights) const;
    /// It is nowhere farther from the triangle, mm.
    double bound() const;
};

/// Where that is farthest from the triangle, no nearer to a side than an eighth of the height over it: what sides tell
/// of the inside is not exact.
struct TrianglePeak {
    std::array<double, 3> weights{};  ///< barycentric
    double height = 0.0;              ///< mm, at least 0
};
TrianglePeak triangle_peak(const TriangleHeights& heights);
/// With the heights that the slopes at the corners let expect; where that tells nothing, the centroid.
TrianglePeak expected_peak(const mesh::SurfaceMesh::Site& a, const mesh::SurfaceMesh::Site& b,
                           const mesh::SurfaceMesh::Site& c);

}  // namespace mq::triangulate

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

/// Over a triangle the surface is taken for a quadratic, which the heights over the middles of the sides determine.
struct TrianglePeak {
    std::array<double, 3> weights{};  ///< barycentric
    double height = 0.0;              ///< mm, at least 0; 0 where the peak is on the border
};
/// `ab`, `bc`, `ca`: heights over the middles of the sides, with sign, mm.
TrianglePeak triangle_peak(double ab, double bc, double ca);
/// With the heights that the slopes at the corners let expect; where that tells nothing, the centroid.
TrianglePeak expected_peak(const mesh::SurfaceMesh::Site& a, const mesh::SurfaceMesh::Site& b,
                           const mesh::SurfaceMesh::Site& c);

}  // namespace mq::triangulate

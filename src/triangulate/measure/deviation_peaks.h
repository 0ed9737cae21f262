// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "triangulate/work_mesh/classified_mesh.h"

/// Estimates where an edge or a triangle is farthest from its surface, from the normals at its corners and the heights
/// over its sides: there it is measured.
namespace mq::triangulate {

/// Between the ends of an edge the surface is approximated by a cubic with its slopes at the ends.
struct EdgePeak {
    double at = 0.5;      ///< fraction of the half-edge's length, in steps of a tenth
    double height = 0.0;  ///< mm, at least 0
};
EdgePeak edge_peak(const ClassifiedMesh& mesh, int half_edge);
/// Estimates the peak of an edge that need not be in the mesh.
EdgePeak edge_peak(const ClassifiedMesh::VertexUse& from, const ClassifiedMesh::VertexUse& to);

/// Returns the asymmetry of the cubic between two sites: at the fraction x of the edge it adds the height skew x (1 -
/// x) (1 - 2 x), mm.
double side_skew(const ClassifiedMesh::VertexUse& from, const ClassifiedMesh::VertexUse& to);

/// The surface over a triangle as a cubic: a quadratic through its heights over the middles of the sides, plus the
/// skew of every side by the slopes at its ends.
struct TriangleHeights {
    std::array<double, 3> middles{};  ///< signed height over the middle of the side from corner k to k + 1, mm
    std::array<double, 3> skews{};    ///< skew of that side, mm; see side_skew

    /// Returns the signed height at barycentric weights, mm.
    double at(const std::array<double, 3>& weights) const;
    /// Returns an upper bound of the absolute height anywhere over the triangle, mm.
    double bound() const;
};

/// The place where the cubic is highest over the triangle, with all barycentric weights at least an eighth: the
/// estimate inside is not exact beside a side.
struct TrianglePeak {
    std::array<double, 3> weights{};  ///< barycentric
    double height = 0.0;              ///< mm, at least 0
};
TrianglePeak triangle_peak(const TriangleHeights& heights);
/// Estimates the peak from the slopes at the corners; returns the centroid where these give no height.
TrianglePeak expected_peak(const ClassifiedMesh::VertexUse& a, const ClassifiedMesh::VertexUse& b,
                           const ClassifiedMesh::VertexUse& c);

}  // namespace mq::triangulate

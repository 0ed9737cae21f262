// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "triangulate/work_mesh/maxmin_swaps.h"

namespace mq::triangulate {

/// The cavity on one face that is left when a vertex is removed: the triangles around it, and their outline.
struct RemovalCavity {
    std::vector<int> triangles;             ///< triangles around the vertex
    std::vector<std::array<int, 2>> sides;  ///< sites at the ends of each side, counter-clockwise
    std::array<int, 2> base{-1, -1};        ///< for a vertex on a CAD edge: the last side, along that edge
    Vec3 normal = Vec3::Zero();  ///< sum of the triangles' normals, each as long as twice the triangle's area
};

/// Returns the cavity around the vertex that `half_edge` leaves. No value if a vertex occurs twice on the outline or
/// with two sites, or a triangle fills a small input angle of the shape.
std::optional<RemovalCavity> removal_cavity(const ClassifiedMesh& mesh, int half_edge);

/// A triangulation of the cavity in which all triangles share one of its corners.
struct Fan {
    int apex_site = -1;
    std::vector<std::array<int, 3>> triangles;  ///< sites
    double angle = 0.0;                         ///< smallest angle, radians
};

/// Returns the fans whose angles reach `least_angle` (radians), the best first.
std::vector<Fan> fans_of(const ClassifiedMesh& mesh, const RemovalCavity& cavity, double least_angle);
/// Whether the fan's alignment with the surface (see alignment) reaches `aligned`, or is at least kAligned and no
/// worse than that of the present triangles.
bool fan_aligned(const ClassifiedMesh& mesh, const RemovalCavity& cavity, const Fan& fan, double aligned);
/// Whether the fan creates no edge that exists already.
bool fan_legal(const ClassifiedMesh& mesh, const MaxMinSwaps& maxmin, const RemovalCavity& cavity, int apex_site);

/// Returns the corners at which inner edges of the fan end, as sites.
std::vector<int> spokes_of(const RemovalCavity& cavity, int apex_site);

}  // namespace mq::triangulate

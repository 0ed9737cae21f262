// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "triangulate/maxmin.h"

namespace mq::triangulate {

/// What is left on one face when a vertex is taken out: the outline of the triangles around it.
struct StarPolygon {
    std::vector<int> triangles;             ///< around the vertex
    std::vector<std::array<int, 2>> sides;  ///< sites at their ends, counter-clockwise
    std::array<int, 2> base{-1, -1};        ///< where the vertex lies on a CAD edge: the last side, along that edge
    Vec3 normal = Vec3::Zero();             ///< sum of the triangles' normals, each as long as twice its area
};

/// Of the vertex that `half_edge` leaves. No value where a vertex is on the outline twice or with two sites, or a
/// triangle fills a narrow corner of the part.
std::optional<StarPolygon> star_polygon(const mesh::SurfaceMesh& mesh, int half_edge);

/// A triangulation of the polygon: all triangles from one of its corners.
struct PolygonFan {
    int apex_site = -1;
    std::vector<std::array<int, 3>> triangles;  ///< sites
    double angle = 0.0;                         ///< the smallest, radians
};

/// The fans whose angles reach `least_angle` (radians), the best first.
std::vector<PolygonFan> fans_of(const mesh::SurfaceMesh& mesh, const StarPolygon& polygon, double least_angle);
/// Whether the fan is aligned with the surface (see alignment) by `aligned`, or, down to kAligned, no less than what is
/// there.
bool fan_aligned(const mesh::SurfaceMesh& mesh, const StarPolygon& polygon, const PolygonFan& fan, double aligned);
/// Whether the fan makes no edge that is there already.
bool fan_legal(const mesh::SurfaceMesh& mesh, const Maxmin& maxmin, const StarPolygon& polygon, int apex_site);

/// The corners that inner edges of the fan lead to, as sites.
std::vector<int> spokes_of(const StarPolygon& polygon, int apex_site);

}  // namespace mq::triangulate

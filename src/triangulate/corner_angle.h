// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mesh/surface_mesh.h"

namespace mq::triangulate {

/// Between segments, radians: what counts as acute, and as narrow.
constexpr double kAcuteCorner = M_PI / 2.0;
constexpr double kNarrowCorner = M_PI / 3.0;

/// The angle that a segment makes with another segment at one of its ends, measured on a face beside it.
struct NarrowCorner {
    double angle = 1e300;  ///< radians; large when the end is no CAD node
    int segment = -1;      ///< the other one
};

/// At end 0 or 1 of the segment, one for each face beside it; none where the end is no CAD node.
std::vector<NarrowCorner> corners_at(const mesh::SurfaceMesh& mesh, int segment, int end);
NarrowCorner narrowest_corner(const mesh::SurfaceMesh& mesh, int segment, int end);

/// The angle at the origin of `h` in its triangle, radians.
double angle_at(const mesh::SurfaceMesh& mesh, int h);

/// The triangles of a face around a vertex where its surface comes to a point.
struct ApexFan {
    std::size_t triangles = 0;
    double sum = 0.0;     ///< of their angles there, radians
    double widest = 0.0;  ///< of these angles
    bool closed = false;  ///< they go round it, whether or not a seam ends there
};
/// Around the origin of `h`; no value where that is no such point: it has a normal there, and one place in (u, v).
std::optional<ApexFan> apex_fan(const mesh::SurfaceMesh& mesh, int h);
/// The same around the apex of a cone so slender that fans there do not come about by themselves: 200 degrees in all.
std::optional<ApexFan> cone_fan(const mesh::SurfaceMesh& mesh, int h);
/// Whether the origin of `h` is such an apex with triangles on all sides.
bool ringed_apex(const mesh::SurfaceMesh& mesh, int h);

/// The corner of a triangle that fills a narrow corner of the part: two segments meet in it at less than 34 degrees,
/// the largest bound there is. A vertex in such a triangle would cut the angle into smaller ones. -1: there is none.
int narrow_corner_of(const mesh::SurfaceMesh& mesh, int triangle);

/// The corner of the triangle with the smallest angle as a half-edge, and that angle in radians.
struct SmallestAngle {
    int half_edge;
    double angle;
};
SmallestAngle smallest_angle(const mesh::SurfaceMesh& mesh, int triangle);

/// Normal to a triangle, as long as twice its area.
Vec3 doubled_area(const mesh::SurfaceMesh& mesh, int triangle);

/// The squared sine of a triangle's smallest angle: it lies between the two longer sides, and is 60 degrees at most.
/// Several times as fast as the angle, and enough to compare by. 0 where two corners are one.
/// @param area a normal as long as twice the area
/// @param a, b, c squared lengths of the sides
inline double squared_sine_of_smallest(const Vec3& area, double a, double b, double c) {
    const double product = a * b * c;
    return product > 0.0 ? area.squaredNorm() * std::min({a, b, c}) / product : 0.0;
}
double squared_sine_of_smallest(const mesh::SurfaceMesh& mesh, int triangle);
/// A squared sine beyond which a smallest angle is more than `angle` (radians), however it is rounded.
inline double surely_beyond(double angle) {
    constexpr double kRounding = 1.0 + 1e-9;
    const double sine = std::sin(angle);
    return kRounding * sine * sine;
}

}  // namespace mq::triangulate

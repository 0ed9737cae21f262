// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "base/angle.h"
#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Radians: corners between segments below this angle are acute, and their pieces are split on shells (see
/// SegmentSplitter).
constexpr double kAcuteCorner = M_PI / 2.0;
// Radians: corners below this angle are small input angles; from 60 degrees on, splitting terminates by itself
// (Shewchuk 2002).
constexpr double kNarrowCorner = M_PI / 3.0;

/// The angle that a segment makes with another segment at one of its ends, measured on a face beside it.
struct NarrowCorner {
    double angle = 1e300;  ///< radians; large if the end is no CAD node
    int segment = -1;      ///< the other segment
};

/// Returns the angles at end 0 or 1 of the segment, one for each face beside it; none if the end is no CAD node.
std::vector<NarrowCorner> corners_at(const ClassifiedMesh& mesh, int segment, int end);
NarrowCorner narrowest_corner(const ClassifiedMesh& mesh, int segment, int end);

/// Returns the angle at the origin of `h` in its triangle, radians.
double angle_at(const ClassifiedMesh& mesh, int h);

/// The triangles of a face around a singular point of its surface.
struct ApexFan {
    std::size_t triangles = 0;
    double sum = 0.0;     ///< sum of their angles at the vertex, radians
    double widest = 0.0;  ///< largest of these angles, radians
    bool closed = false;  ///< whether they surround the vertex, even if a seam ends there
};
/// Returns the fan around the origin of `h`; no value at a regular point, which has a normal and one place in (u, v),
/// nor where there are more than `most` triangles.
std::optional<ApexFan> apex_fan(const ClassifiedMesh& mesh, int h, std::size_t most = SIZE_MAX);
/// The same for the apex of a cone so slender that good fans do not arise by themselves: with a total angle below 200
/// degrees.
std::optional<ApexFan> cone_fan(const ClassifiedMesh& mesh, int h);
/// Whether the origin of `h` is such an apex with triangles on all sides, none of which is too wide.
bool ringed_apex(const ClassifiedMesh& mesh, int h);

/// Returns the corner of a triangle that fills a small input angle of the shape: two segments meet in it at less than
/// 34 degrees, the largest bound allowed. A vertex in such a triangle would divide the angle into smaller ones. -1:
/// there is none.
int narrow_corner_of(const ClassifiedMesh& mesh, int triangle);

/// The corner of the triangle with the smallest angle as a half-edge, and that angle in radians.
struct SmallestAngle {
    int half_edge;
    double angle;
};
SmallestAngle smallest_angle(const ClassifiedMesh& mesh, int triangle);

/// Returns the normal of a triangle, as long as twice its area.
Vec3 doubled_area(const ClassifiedMesh& mesh, int triangle);

using mq::squared_sine_of_smallest_angle;  // not hidden by the one of a triangle of the mesh
/// Returns the squared sine of the smallest angle of a triangle of the mesh, for comparisons.
double squared_sine_of_smallest_angle(const ClassifiedMesh& mesh, int triangle);
constexpr double kRoundingOfSine = 1e-9;  ///< relative margin for rounding of the squared sine
/// Returns a squared sine beyond which the smallest angle exceeds `angle` (radians) despite rounding.
inline double sine_squared_above(double angle) {
    const double sine = std::sin(angle);
    return (1.0 + kRoundingOfSine) * sine * sine;
}
/// Returns a squared sine below which the smallest angle is below `angle` (radians) despite rounding.
inline double sine_squared_below(double angle) {
    const double sine = std::sin(angle);
    return (1.0 - kRoundingOfSine) * sine * sine;
}

}  // namespace mq::triangulate

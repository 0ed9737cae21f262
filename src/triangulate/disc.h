// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "triangulate/fold.h"
#include "triangulate/maxmin.h"

namespace mq::triangulate {

/// Triangles of one face that hang together as a disc. What is inside may be replaced by a fan: all triangles between
/// the rim and one apex, which is a new vertex or one of the rim.
struct Disc {
    std::vector<int> triangles;
    std::vector<int> rim;        ///< half-edges of these triangles on the border of the disc
    Vec3 normal = Vec3::Zero();  ///< sum of the triangles' normals, each as long as twice its area
};

/// No value when the triangles are no disc, a vertex is twice on the rim or has two sites, or one of them fills a
/// narrow corner of the part (see narrow_corner_of).
std::optional<Disc> disc_of(const mesh::SurfaceMesh& mesh, std::vector<int> triangles);

/// All triangles of the face around the origin of `h`.
std::vector<int> triangles_around(const mesh::SurfaceMesh& mesh, int h);

/// The smallest angle, radians, of the disc's triangles as they are.
double smallest_angle(const mesh::SurfaceMesh& mesh, const Disc& disc);
/// The smallest angle of the fan from `apex` to the sides of the rim that do not end at the site `apex_site` (-1: to
/// all); -1 where a triangle would be turned over against the disc's normal.
double fan_angle(const mesh::SurfaceMesh& mesh, const Disc& disc, const Vec3& apex, int apex_site = -1);
/// The side of the rim whose triangle has the smallest angle in the fan from a new vertex.
int worst_side(const mesh::SurfaceMesh& mesh, const Disc& disc, const Vec3& apex);
/// The smallest alignment (see alignment) of the fan's triangles, or of the disc's.
double fan_alignment(const mesh::SurfaceMesh& mesh, const Disc& disc, const Corner& apex, int apex_site = -1);
double disc_alignment(const mesh::SurfaceMesh& mesh, const Disc& disc);

/// Where in the plane of the disc the apex of the fan with the largest smallest angle lies, by a pattern search; only
/// roughly where that is far less than `at_least` (radians).
Vec3 best_apex(const mesh::SurfaceMesh& mesh, const Disc& disc, double at_least = 0.0);

/// The best of a few places for it.
Vec3 rough_apex(const mesh::SurfaceMesh& mesh, const Disc& disc);

/// A fan to all corners of a rim but one, which an ear cuts off: a triangle of it and the corners next to it.
struct EaredFan {
    int ear_site = -1;
    Vec3 apex = Vec3::Zero();
    double angle = 0.0;  ///< the smallest of all triangles, the ear among them; -1: one would be turned over
};
/// The best one for each corner of the rim, in the order of the rim's sides. `at_least` as for best_apex.
std::vector<EaredFan> eared_fans(const mesh::SurfaceMesh& mesh, const Disc& disc, double at_least);

/// Whether a fan from a site of the rim makes no edge that is there already outside the disc.
bool rim_apex_legal(const mesh::SurfaceMesh& mesh, const Maxmin& maxmin, const Disc& disc, int apex_site);

/// The triangles of the fan from a site, as corners.
std::vector<std::array<int, 3>> fan(const mesh::SurfaceMesh& mesh, const Disc& disc, int apex_site);

}  // namespace mq::triangulate

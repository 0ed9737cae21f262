// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "triangulate/work_mesh/maxmin_swaps.h"
#include "triangulate/work_mesh/surface_alignment.h"

namespace mq::triangulate {

/// Triangles of one face that form a disc. Its interior may be replaced by a fan: all triangles between the boundary
/// and one apex, which is a new vertex or one on the boundary.
struct Cavity {
    std::vector<int> triangles;
    std::vector<int> rim;        ///< half-edges of these triangles on the boundary of the disc
    Vec3 normal = Vec3::Zero();  ///< sum of the triangles' normals, each as long as twice the triangle's area
};

/// Returns no value if the triangles are no disc, a vertex occurs twice on the boundary or has two sites, or a
/// triangle fills a small input angle of the shape (see narrow_corner_of).
std::optional<Cavity> disc_of(const ClassifiedMesh& mesh, std::vector<int> triangles);

/// Returns all triangles of the face around the origin of `h`; none where there are more than `most`.
std::vector<int> triangles_around(const ClassifiedMesh& mesh, int h, std::size_t most = SIZE_MAX);

/// Returns the smallest angle of the disc's present triangles, radians.
double smallest_angle(const ClassifiedMesh& mesh, const Cavity& disc);
/// Returns the smallest angle of the fan from `apex` to the sides of the boundary that do not end at the site
/// `apex_site` (-1: to all), radians; -1 if a triangle would be inverted with respect to the disc's normal, or,
/// found out early, an angle is below `at_least` by more than rounding.
double fan_angle(const ClassifiedMesh& mesh, const Cavity& disc, const Vec3& apex, int apex_site = -1,
                 double at_least = 0.0);
/// Returns the side of the boundary whose triangle has the smallest angle in the fan from a new vertex.
int worst_side(const ClassifiedMesh& mesh, const Cavity& disc, const Vec3& apex);
/// Returns the smallest alignment (see alignment) of the fan's triangles, or of the disc's.
double fan_alignment(const ClassifiedMesh& mesh, const Cavity& disc, const Corner& apex, int apex_site = -1);
double disc_alignment(const ClassifiedMesh& mesh, const Cavity& disc);

/// Finds, by a pattern search in the plane of the disc, the apex of the fan with the largest smallest angle.
Vec3 best_apex(const ClassifiedMesh& mesh, const Cavity& disc);

/// Returns the best of a few fixed candidates for that apex.
Vec3 rough_apex(const ClassifiedMesh& mesh, const Cavity& disc);

/// Whether a fan from a site of the boundary creates no edge that exists already outside the disc.
bool rim_apex_legal(const ClassifiedMesh& mesh, const MaxMinSwaps& maxmin, const Cavity& disc, int apex_site);

/// Returns the triangles of the fan from a site, as corners.
std::vector<std::array<int, 3>> fan(const ClassifiedMesh& mesh, const Cavity& disc, int apex_site);

}  // namespace mq::triangulate

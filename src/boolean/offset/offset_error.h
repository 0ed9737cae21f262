// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/triangle_distance.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// A surface with the tree of its triangles, for questions of distance. Both lists must outlive it.
struct SearchedSurface {
    SearchedSurface(const std::vector<Vec3>& its_points, const std::vector<mesh::Triangle>& its_triangles)
        : points(its_points), triangles(its_triangles), tree(its_points, its_triangles) {}

    const std::vector<Vec3>& points;
    const std::vector<mesh::Triangle>& triangles;
    const mesh::NearestTree tree;
};

using mesh::Corners;

/// A bound, mm, and where it was found.
struct ProvenBound {
    double bound = 0.0;
    Vec3 where = Vec3::Zero();
};

/// Whether all points of a triangle are nearer to a surface than a distance, as far as a proof of a few divisions
/// shows.
bool all_nearer(const Corners& triangle, const SearchedSurface& surface, double distance);

/// A bound for |d - distance| over all points of some triangles, where d is a point's distance from a surface.
///
/// Over a triangle the distance from one triangle of the surface is convex, so that its corners bound it from above;
/// from below it is bounded by the exact distances of edges and corners. Triangles are divided until both are within
/// `fineness` (mm) of what is attained.
ProvenBound deviation_from_distance(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                    double distance, double fineness, const Progress& progress);

/// The triangles, by their numbers, of which that bound is above `most` (mm).
std::vector<std::int32_t> triangles_beyond(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                           double distance, double most, double fineness, const Progress& progress);

/// A bound for the distances from `result` of those points of some triangles that may lie on the exact offset: which
/// are at least `least` (mm) in front of a surface, and do not come nearer to another side of it before they are moved
/// on by `gap` (mm) along the triangle's normal. Distances up to `enough` are taken as that.
ProvenBound distance_of_outer_points(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                     double least, double gap, const SearchedSurface& result, double enough,
                                     const Progress& progress);

}  // namespace mq::boolean

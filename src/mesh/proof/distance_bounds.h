// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/triangle_distance.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// A surface with the tree of its triangles, for queries of distances. Both must outlive this object.
struct SearchedSurface {
    SearchedSurface(const std::vector<Vec3>& its_points, const std::vector<Triangle>& its_triangles)
        : points(its_points), triangles(its_triangles), tree(its_points, its_triangles) {}

    const std::vector<Vec3>& points;
    const std::vector<Triangle>& triangles;
    const NearestTree tree;
};

/// A bound, mm, and the place where it was found.
struct ProvenBound {
    double bound = 0.0;
    Vec3 where = Vec3::Zero();
};

/// Whether all points of a triangle are nearer to a surface than a distance. False if a few divisions do not prove it.
bool all_nearer(const Corners& triangle, const SearchedSurface& surface, double distance);

/// A bound for |d - distance| over all points of some triangles, where d is a point's distance from a surface.
///
/// The distance of a point from one triangle of the surface is a convex function of the point: its values at the
/// corners of a triangle bound it from above. The exact distances of edges and corners bound it from below. Triangles
/// are divided until the two bounds differ by at most `fineness` (mm).
ProvenBound deviation_from_distance(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                    double distance, double fineness, const Progress& progress);

/// A bound for the distance from a closed surface of all points of some triangles that are outside of it; `fineness`
/// (mm) where no point is farther. The bound is at most the fineness above the largest distance, as in
/// deviation_from_distance.
/// @param is_inside  whether a point is inside of the surface; called by several threads
/// @param from  fraction of the stage that was done before; this call advances it to the end
ProvenBound distance_of_points_outside(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                       const std::function<bool(const Vec3&)>& is_inside, double fineness,
                                       Progress& progress, double from = 0.0);

/// The indices of the triangles for which deviation_from_distance is above `most` (mm).
/// @param witnesses  by triangle, for distance = 0: triangles of the surface that prove by themselves that it is not;
/// null: not asked for
/// @param places  gets a point of each of those triangles where it is; null: not asked for
std::vector<std::int32_t> triangles_beyond(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                           double distance, double most, double fineness, const Progress& progress,
                                           std::vector<std::vector<std::int32_t>>* witnesses = nullptr,
                                           std::vector<Vec3>* places = nullptr);

/// A bound for the distances from `result` of the points of some triangles that may lie on the exact offset: those at
/// least `least` (mm) in front of a surface that come no nearer to other triangles of it when they are moved by `gap`
/// (mm) along the triangle's normal. Distances below `enough` (mm) are raised to `enough`.
ProvenBound distance_of_outer_points(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                     double least, double gap, const SearchedSurface& result, double enough,
                                     const Progress& progress);

}  // namespace mq::mesh

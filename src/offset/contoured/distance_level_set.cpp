// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/contoured/distance_level_set.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "mesh/intersection/triangle_distance.h"

namespace mq::offset {

DistanceLevelSet::DistanceLevelSet(const OffsetSurface& surface, double distance, double resolution)
    : surface_(surface),
      distance_(distance),
      resolution_(resolution),
      searched_(surface.points, surface.triangles),
      faces_(surface.triangles.size()),
      vertices_(surface.points.size()) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto triangle = static_cast<std::int32_t>(t);
        const mesh::Triangle& c = surface.triangles[t];
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = surface.points[static_cast<std::size_t>(c[k])];
        }
        const Vec3 cross = (p[1] - p[0]).cross(p[2] - p[0]);
        faces_[t] = {cross.squaredNorm() > 0.0 ? Vec3(cross.normalized()) : Vec3(Vec3::Zero()), triangle};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 to_next = p[(k + 1) % 3] - p[k];
            const Vec3 to_last = p[(k + 2) % 3] - p[k];
            const double angle = std::atan2(to_next.cross(to_last).norm(), to_next.dot(to_last));
            add(vertices_[static_cast<std::size_t>(c[k])], triangle, angle);
            add(edges_.insert({pair_key(c[k], c[(k + 1) % 3]), Feature()}).first.value(), triangle, 1.0);
        }
    }
}

/// Among the triangles at a feature the one with the lowest patch represents it, so that rounding errors do not divide
/// its
/// offset.
void DistanceLevelSet::add(Feature& feature, std::int32_t triangle, double weight) const {
    feature.normal += weight * faces_[static_cast<std::size_t>(triangle)].normal;
    if (feature.triangle < 0 ||
        std::make_tuple(patch(triangle), triangle) < std::make_tuple(patch(feature.triangle), feature.triangle)) {
        feature.triangle = triangle;
    }
}

Vec3 DistanceLevelSet::nearest(const Vec3& point, std::int32_t triangle) const {
    const mesh::Triangle& c = surface_.triangles[static_cast<std::size_t>(triangle)];
    return mesh::nearest_on_triangle(point, surface_.points[static_cast<std::size_t>(c[0])],
                                     surface_.points[static_cast<std::size_t>(c[1])],
                                     surface_.points[static_cast<std::size_t>(c[2])]);
}

/// The face, edge or vertex of a triangle that contains a point of it.
const DistanceLevelSet::Feature& DistanceLevelSet::feature_at(std::int32_t triangle, const Vec3& point) const {
    constexpr double kOnEdge = 1e-9;  // barycentric coordinate
    const mesh::Triangle& c = surface_.triangles[static_cast<std::size_t>(triangle)];
    const auto corner = [&](std::size_t k) -> const Vec3& {
        return surface_.points[static_cast<std::size_t>(c[k % 3])];
    };
    const Vec3 cross = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const double area = cross.squaredNorm();
    std::array<bool, 3> is_opposite{};  // whether the point lies on the edge opposite to a corner
    std::size_t edges = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        is_opposite[k] = (corner(k + 2) - corner(k + 1)).cross(point - corner(k + 1)).dot(cross) < kOnEdge * area;
        edges += is_opposite[k] ? 1 : 0;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        if (edges == 1 && is_opposite[k]) {
            return edges_.at(pair_key(c[(k + 1) % 3], c[(k + 2) % 3]));
        }
        if (edges == 2 && !is_opposite[k]) {
            return vertices_[static_cast<std::size_t>(c[k])];
        }
    }
    return faces_[static_cast<std::size_t>(triangle)];
}

contour::LevelSample DistanceLevelSet::at(const Vec3& point, std::int32_t guess) const {
    const mesh::ClosestPoint closest = guess >= 0 ? tree().nearest_from(point, guess) : tree().nearest(point);
    const Feature& feature = feature_at(closest.triangle, closest.point);
    const Vec3 away = point - closest.point;
    const double sign = surface_.is_solid && away.dot(feature.normal) < 0.0 ? -1.0 : 1.0;
    contour::LevelSample level;
    level.value = sign * closest.distance - distance_;
    level.gradient = closest.distance > 0.0 ? Vec3(sign / closest.distance * away) : Vec3(feature.normal.normalized());
    level.source = feature.triangle;
    return level;
}

}  // namespace mq::offset

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "base/vec.h"
#include "contour/level_set.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/proof/distance_bounds.h"
#include "mesh/triangle_mesh.h"

namespace mq::offset {

/// The surface from which an offset is made. It must outlive the objects that use it.
struct OffsetSurface {
    std::vector<Vec3> points;
    std::vector<mesh::Triangle> triangles;  ///< closed and oriented outward if it is a solid
    std::vector<std::int32_t> patch;        ///< by triangle
    bool is_solid = true;                   ///< false: a distance counts on both sides of the surface
};

/// The distance from a surface less a given distance: the level set of an offset. Distances inside of a solid are
/// negative.
///
/// The sign of a point's distance is that of its height over the pseudonormal of the nearest feature. The pseudonormal
/// of a face is its normal, that of an edge the sum of both normals, that of a vertex the sum weighted by angles
/// (Baerentzen and Aanaes 2005, Signed distance computation using the angle weighted pseudonormal, section 3).
class DistanceLevelSet : public contour::LevelSet {
  public:
    /// @param resolution  see LevelSet
    DistanceLevelSet(const OffsetSurface& surface, double distance, double resolution);

    contour::LevelSample at(const Vec3& point, std::int32_t guess) const override;
    std::int32_t patch(std::int32_t source) const override { return surface_.patch[static_cast<std::size_t>(source)]; }
    double least_radius() const override { return distance_; }
    double resolution() const override { return resolution_; }

    double distance() const { return distance_; }
    const mesh::SearchedSurface& searched() const { return searched_; }
    const mesh::NearestTree& tree() const { return searched_.tree; }
    /// The point of a triangle nearest to another point.
    Vec3 nearest(const Vec3& point, std::int32_t triangle) const;

  private:
    /// An edge or a vertex: its pseudonormal, and the triangle that represents it.
    struct Feature {
        Vec3 normal = Vec3::Zero();
        std::int32_t triangle = -1;
    };
    void add(Feature& feature, std::int32_t triangle, double weight) const;
    const Feature& feature_at(std::int32_t triangle, const Vec3& point) const;

    const OffsetSurface& surface_;
    const double distance_;
    const double resolution_;
    const mesh::SearchedSurface searched_;
    std::vector<Feature> faces_;
    std::vector<Feature> vertices_;
    KeyMap<Feature> edges_;
};

}  // namespace mq::offset

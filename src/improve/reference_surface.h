// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "improve/editable_mesh.h"
#include "mesh/intersection/nearest_tree.h"

namespace mq::improve {

/// The given surface, and its sharp edges as curves: the reference for the distances of the improved mesh. For one
/// thread at a time.
class ReferenceSurface {
  public:
    /// The mesh must outlive this.
    ReferenceSurface(const mesh::TriangleMesh& given, const EditableMesh& edges);

    /// Whether the surface, or a sharp edge, is at most `distance` (mm) from a point.
    bool within(const Vec3& p, double distance) const;
    bool sharp_edges_within(const Vec3& p, double distance) const;
    /// The nearest point of the surface, or of its sharp edges, as a single-precision number.
    Vec3 project(const Vec3& p) const;
    Vec3 project_to_sharp_edges(const Vec3& p) const;
    struct SurfaceProjection {
        double distance;
        Vec3 normal;  ///< unit normal; zero where the triangle there is too thin to have one
    };
    /// The projection of a point to the surface.
    SurfaceProjection foot(const Vec3& p) const;

  private:
    const mesh::TriangleMesh& given_;
    std::vector<Triangle> sharp_;  // each edge as a triangle without area
    mesh::NearestTree tree_;
    mesh::NearestTree curves_;
    // The last result, as queries are mostly near the one before. It makes searches faster, and does not change their
    // results.
    mutable std::int32_t last_ = 0;
    mutable std::int32_t last_sharp_ = 0;
};

/// The same point in single precision.
Vec3 in_single(const Vec3& p);

}  // namespace mq::improve

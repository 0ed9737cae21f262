// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/triangle_mesh.h"
#include "mesh/vertex_stars.h"

namespace mq::inspection {

/// The signed distance of a point from a surface, and where that is.
struct SignedDistance {
    double value = 0.0;           ///< mm; negative behind the surface: inside of a solid
    Vec3 nearest = Vec3::Zero();  ///< the point of the surface nearest to the point
    /// Unit vector along which the distance grows: the outward normal there, or at edges the direction to the point.
    Vec3 normal = Vec3::Zero();
    std::int32_t triangle = -1;  ///< the triangle nearest to the point
    std::int32_t face = -1;      ///< the CAD face of the nearest point; -1: there is no CAD
};

/// The signed distance for a point, its nearest point, and a normal there whose length is of no consequence: any vector
/// that has a positive product with the direction to the outside.
SignedDistance signed_distance(const Vec3& point, const Vec3& nearest, const Vec3& normal);

/// Signed distances of points from a mesh. The sign is that of the angle-weighted pseudonormal (Baerentzen and Aanaes
/// 2005) of the triangle, edge or vertex with the nearest point, which is exact for closed, oriented meshes; beside the
/// border of an open mesh it says on which side of the triangles there the point is.
class MeshDistance {
  public:
    /// @param mesh  outlives it; its origin is left out of account. Vertices with equal coordinates count as one.
    explicit MeshDistance(const mesh::TriangleMesh& mesh);

    /// @param guess  a triangle near the point, for speed; -1: none is known
    SignedDistance at(const Vec3& point, std::int32_t guess) const;
    mesh::ClosestPoint nearest(const Vec3& point, std::int32_t guess) const {
        return guess < 0 ? tree_.nearest(point) : tree_.nearest_from(point, guess);
    }
    const mesh::NearestTree& tree() const { return tree_; }
    const mesh::TriangleMesh& mesh() const { return mesh_; }
    /// The pseudonormal at a point of a triangle.
    Vec3 pseudonormal(std::int32_t triangle, const Vec3& at) const;

  private:
    std::vector<mesh::Triangle> welded() const;
    Vec3 unit_normal(std::int32_t triangle) const;

    const mesh::TriangleMesh& mesh_;
    std::vector<mesh::Triangle> triangles_;  ///< by the lowest vertex of each place
    mesh::NearestTree tree_;
    mesh::VertexStars stars_;
};

}  // namespace mq::inspection

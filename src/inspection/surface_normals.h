// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "mesh/triangle_mesh.h"

namespace mq::inspection {

/// The normals of the smooth surface that a mesh stands for.
///
/// The normal of a corner is a weighted mean (Max 1999) over the triangles around its vertex that continue its own
/// triangle smoothly: the triangles of the same CAD face or, without CAD, those whose normals differ by less than 30
/// degrees.
class SurfaceNormals {
  public:
    explicit SurfaceNormals(const mesh::TriangleMesh& mesh, const Progress* progress = nullptr);

    /// The normal of a triangle's own plane; zero for a triangle without area.
    const Vec3& of_plane(std::int32_t triangle) const { return plane_[static_cast<std::size_t>(triangle)]; }
    /// The normal at a point of the triangle, of length 1, interpolated between the normals of its corners.
    /// @param weights  barycentric coordinates
    Vec3 at(std::int32_t triangle, const Vec3& weights) const;
    /// About 4 times the distance of the triangle and of its neighbours from the smooth surface, mm: a ball that
    /// touches the smooth surface anywhere on the triangle cuts no deeper than this into the mesh nearby. 0 on plane
    /// faces.
    ///
    /// A chord of length l between normals that differ by an angle d lies l d / 8 off its arc. The ball that touches
    /// the arc from inside at the chord's end cuts 4 times as deep into the next chord, and less so elsewhere.
    double allowance(std::int32_t triangle) const { return allowance_[static_cast<std::size_t>(triangle)]; }

  private:
    std::vector<Vec3> plane_;
    std::vector<std::array<Vec3, 3>> corner_;
    std::vector<double> allowance_;
};

}  // namespace mq::inspection

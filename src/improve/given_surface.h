// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "improve/editable_mesh.h"
#include "mesh/triangle_tree.h"

namespace mq::improve {

/// The surface that was given, and its sharp edges as curves: what the improved mesh is measured against.
class GivenSurface {
  public:
    /// The mesh must outlive this.
    GivenSurface(const mesh::TriangleMesh& given, const EditableMesh& edges);

    double distance(const Vec3& p) const { return tree_.nearest(p).distance; }
    double distance_to_sharp_edges(const Vec3& p) const { return curves_.nearest(p).distance; }
    /// The nearest point of the surface, or of its sharp edges, as a single-precision number.
    Vec3 project(const Vec3& p) const;
    Vec3 project_to_sharp_edges(const Vec3& p) const;
    /// The unit normal where the surface is nearest to a point; zero where the triangle there is too thin to have one.
    Vec3 normal(const Vec3& p) const;

  private:
    const mesh::TriangleMesh& given_;
    std::vector<Triangle> sharp_;  // each an edge as a triangle without area
    mesh::TriangleTree tree_;
    mesh::TriangleTree curves_;
};

/// The same point in single precision.
Vec3 in_single(const Vec3& p);

}  // namespace mq::improve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "improve/editable_mesh.h"
#include "mesh/triangle_tree.h"

namespace mq::improve {

/// The surface that was given, and its sharp edges as curves: what the improved mesh is measured against. For one
/// thread at a time.
class GivenSurface {
  public:
    /// The mesh must outlive this.
    GivenSurface(const mesh::TriangleMesh& given, const EditableMesh& edges);

    /// Whether the surface, or a sharp edge, is at most so far from a point.
    bool within(const Vec3& p, double distance) const;
    bool sharp_edges_within(const Vec3& p, double distance) const;
    /// The nearest point of the surface, or of its sharp edges, as a single-precision number.
    Vec3 project(const Vec3& p) const;
    Vec3 project_to_sharp_edges(const Vec3& p) const;
    struct Foot {
        double distance;
        Vec3 normal;  ///< of unit length; zero where the triangle there is too thin to have one
    };
    /// Where the surface is nearest to a point.
    Foot foot(const Vec3& p) const;

  private:
    const mesh::TriangleMesh& given_;
    std::vector<Triangle> sharp_;  // each an edge as a triangle without area
    mesh::TriangleTree tree_;
    mesh::TriangleTree curves_;
    // What was found last, as one question is mostly near the one before it. Makes answers faster, not other ones.
    mutable std::int32_t last_ = 0;
    mutable std::int32_t last_sharp_ = 0;
};

/// The same point in single precision.
Vec3 in_single(const Vec3& p);

}  // namespace mq::improve

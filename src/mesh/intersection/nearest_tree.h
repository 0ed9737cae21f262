// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/vec.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// The point of a set of triangles nearest to a given point.
struct ClosestPoint {
    std::int32_t triangle = -1;  ///< -1: none within the bound
    Vec3 point = Vec3::Zero();
    double distance = std::numeric_limits<double>::infinity();  ///< distance, mm
};

/// An AabbTree that is also asked for the triangle nearest to a point. Four boxes at a time are measured by the
/// processor's vector instructions (Dammertz, Hanika, Keller 2008: shallow bounding volume hierarchies); 40 bytes for
/// each triangle besides those of the AabbTree.
class NearestTree : public AabbTree {
  public:
    NearestTree(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles);
    /// A tree over some of the triangles only, each named once.
    NearestTree(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                const std::vector<std::int32_t>& subset);

    /// The triangle nearest to p among those at most `bound` away (mm); among equally near ones the one with the lowest
    /// index.
    ClosestPoint nearest(const Vec3& p, double bound = std::numeric_limits<double>::infinity()) const;
    /// The same query without a bound, which is faster the nearer the triangle `guess` is to p.
    ClosestPoint nearest_from(const Vec3& p, std::int32_t guess) const;
    /// Any triangle at most `distance` away (mm); -1: none. It is `guess`, a triangle of the tree, if that is near
    /// enough.
    std::int32_t any_within(const Vec3& p, double distance, std::int32_t guess) const;
    /// Replaces `found` by all triangles at most `distance` away (mm), each with its point nearest to p: nearest first,
    /// of equally near ones the one with the lowest index.
    void all_within(const Vec3& p, double distance, std::vector<ClosestPoint>& found) const;

  private:
    static constexpr std::size_t kWidth = 4;
    using Lanes = Eigen::Array<float, kWidth, 1>;
    static constexpr std::int32_t kNoChild = 0;  ///< the root, which is no child
    /// Four boxes. A child is a node, ~triangle, or kNoChild.
    struct WideNode {
        std::array<Lanes, 3> low;
        std::array<Lanes, 3> high;
        std::array<std::int32_t, kWidth> child;
    };
    class Point;

    void build();
    std::int32_t add(std::int32_t binary);
    Vec3 nearest_on(std::int32_t triangle, const Vec3& p) const;
    void search(const Vec3& p, ClosestPoint& best, double best_squared) const;
    template <typename Visit>
    void for_each_near(const Vec3& p, const double& bound_squared, Visit&& visit) const;

    std::vector<WideNode> wide_;
};

}  // namespace mq::mesh

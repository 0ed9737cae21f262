// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/intersection/aabb_tree.h"

namespace mq::mesh {

/// The generalised winding number of triangles that need not close (Jacobson, Kavan and Sorkine-Hornung 2013): their
/// solid angle divided by 4 pi. It is 1 within a closed surface and 0 outside; across a hole it goes from 1 to 0
/// smoothly.
///
/// Far triangles are taken together by the first three terms of the expansion of Barill, Dickson, Schmidt, Levin and
/// Jacobson 2018, so that a value takes O(log n); it is within 0.003 of the sum over all triangles.
///
/// The vertices and triangles are referred to, not copied: they must outlive this and keep their places. Vertices with
/// equal coordinates must have one index, or the edges between them count as a border.
class SurfaceWinding {
  public:
    SurfaceWinding(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles);

    double at(const Vec3& p) const;
    /// The gradient where it is smooth, off the triangles, per mm. It is a line integral along the border (the law of
    /// Biot and Savart), as the solid angle of a closed surface has none.
    Vec3 gradient(const Vec3& p) const;
    /// A bound of the length of the gradient in the ball around p, per mm; infinite where the border is in the ball.
    double steepest(const Vec3& p, double radius) const;

    /// The border as degenerate triangles (a, b, b): each edge along which k more triangles run from a to b than from b
    /// to a occurs k times.
    const std::vector<Triangle>& border() const { return border_; }
    const AabbTree& tree() const { return tree_; }

  private:
    /// The triangles of a node in the expansion: moments of their normals by area, about the centre of their area.
    struct Moments {
        Vec3 centre = Vec3::Zero();  ///< mm
        double radius = 0.0;         ///< the radius of a ball around the centre that holds them, mm
        double area = 0.0;           ///< mm2
        Vec3 normal = Vec3::Zero();
        Eigen::Matrix3d first =
            Eigen::Matrix3d::Zero();  ///< column i: moment of the position with component i of the normal
        std::array<Eigen::Matrix3d, 3> second{first, first,
                                              first};  ///< moments with the tensor product of the position with itself

        void add(const Moments& other);
        void move_to_centre(const Vec3& origin);
    };
    /// The border edges of a node in the bound.
    struct Current {
        Box box;
        double length = 0.0;
        Vec3 along = Vec3::Zero();   ///< sum of edges
        Vec3 centre = Vec3::Zero();  ///< the mean of the edges, weighted by length
    };
    void sum_moments();
    void sum_currents();
    double steepest_by_border(const Vec3& p, double radius) const;
    double steepest_by_area(const Vec3& p, double radius) const;
    static double far_winding(const Moments& moments, const Vec3& r, double distance);

    const std::vector<Vec3>& vertices_;
    const std::vector<Triangle>& triangles_;
    std::vector<Triangle> border_;
    AabbTree tree_;
    AabbTree border_tree_;
    std::vector<Moments> moments_;   ///< by node of tree_
    std::vector<Current> currents_;  ///< by node of border_tree_
};

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/LU>
#include <array>
#include <cstddef>
#include <vector>

#include "base/vec.h"
#include "boolean/exact_solid.h"

namespace mq::boolean {

/// Bounds the distance of one point from the surface of a solid from above.
class DistanceToSolid {
  public:
    DistanceToSolid(const ExactSolid& solid, const Vec3& p) : solid_(solid), p_(p) {}

    /// The least bound, as a multiple of the distance by which the sides of the solid's surface are told apart.
    static constexpr double kLeastBound = 8.0;

    /// @param enough  a bound up to this is not improved
    double bound(double enough);

  private:
    /// Factor by which the ball grows in which triangles are searched.
    static constexpr double kWider = 2.0;
    /// Factors by which steps are longer than the way to a surface; the next one is used if a step is too short, as on
    /// curved surfaces.
    static constexpr std::array<double, 4> kBeyond{1.0, 1.01, 1.1, 1.5};
    /// Steps count as equal if the distance of their ends is less than this fraction of their length.
    static constexpr double kSame = 0.05;
    /// Steps shorter than this, as a fraction of the ball's radius, are not combined in pairs: they were tried in
    /// smaller balls.
    static constexpr double kNear = 0.125;
    /// Most steps that are tried singly, with the surroundings of their ends, in pairs, and in threes.
    static constexpr std::size_t kMostSteps = 256;
    static constexpr std::size_t kMostAround = 8;
    static constexpr std::size_t kMostInPairs = 16;
    static constexpr std::size_t kMostInThrees = 6;

    /// Whether a triangle at p bounds the solid at p, or slightly nearer to one of its corners: at an edge, a vertex or
    /// a curve of intersection the solid may be on one side of a fraction of the triangle only.
    bool lies_on() const;

    /// Whether the point a step away, and a little farther, is on another side than p.
    bool try_step(const Vec3& step);

    /// Tries points slightly beside the end of a step, in four directions: if the step leads along a face to an edge,
    /// points beyond its end are on a border of the solid themselves.
    bool try_around(const Vec3& step);

    /// Tries the steps to the nearest points of the triangles in a ball; triangles nearer than `searched` were tried
    /// singly before.
    void search(double searched, double reach);

    /// Whether a point on another side than p is found at this distance.
    bool is_any_beyond(double distance) const;

    /// Tries points in all directions around p, for places without a plane that gives the direction, as at edges and
    /// vertices.
    void probe(double radius);

    /// Accepts a step to the other side, up to the surface on its way.
    void shorten(const Vec3& step);

    /// The ways to the nearest points of triangles around p, the shortest first.
    std::vector<Vec3> steps_within(double reach) const;

    /// The first of those steps, none shorter than `least`, whose ends are not near to each other.
    static std::vector<Vec3> steps_apart(const std::vector<Vec3>& steps, double least);

    /// The shortest step to the line, or point, in which the planes at the ends of steps meet, where it crosses all.
    template <std::size_t n>
    void try_to_meet(const Vec3* const (&steps)[n]) {
        Eigen::Matrix<double, n, n> products;
        Eigen::Matrix<double, n, 1> lengths;
        for (std::size_t i = 0; i < n; ++i) {
            lengths[i] = steps[i]->norm();
            for (std::size_t j = 0; j < n; ++j) {
                products(i, j) = steps[i]->dot(*steps[j]) / (lengths[i] * steps[j]->norm());
            }
        }
        constexpr double kIndependent = 1e-3;  // determinant: normals about 2 degrees apart
        if (lengths.minCoeff() <= 0.0 || products.determinant() < kIndependent) {
            return;
        }
        const Eigen::Matrix<double, n, 1> shares = products.inverse() * lengths;
        Vec3 step = Vec3::Zero();
        for (std::size_t i = 0; i < n; ++i) {
            step += shares[i] / lengths[i] * *steps[i];
        }
        if (shares.minCoeff() > 0.0) {
            try_step(step);
        }
    }

    const ExactSolid& solid_;
    const Vec3 p_;
    bool inside_ = false;
    double best_ = 0.0;
};

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/session.h"

namespace mq::boolean {

/// A surface on which a point is to lie: a face of a model, or a plane.
struct SurfaceConstraint {
    std::int32_t operand = -1;  ///< whose model has the face
    std::int32_t face = -1;     ///< -1: a plane
    Vec3 foot = Vec3::Zero(), normal = Vec3::Zero();
    double u = 0.0, v = 0.0;
    bool asked = false;  ///< foot, normal and (u, v) are those of the last projection

    double distance(const Vec3& p) const { return face < 0 ? std::abs(normal.dot(foot - p)) : (foot - p).norm(); }
};

/// A vertex that is to lie on all its surfaces.
struct MovedVertex {
    std::int32_t vertex = -1;
    Vec3 before = Vec3::Zero(), now = Vec3::Zero();
    double farthest = 0.0;  ///< largest move, mm; a vertex that moves twice as far is lost
    std::vector<SurfaceConstraint> surfaces;
    double first_distance = 0.0;  ///< distance from its surfaces before it moved, mm
    bool lost = false;            ///< a projection failed, or it went too far

    double distance() const;
};

/// Moves vertices onto the intersections of their surfaces by Newton's method on all surfaces at once, with the least
/// displacement in each step.
class FaceIntersections {
  public:
    /// @param operands  each with its `model`; null where it has planes only
    /// @param origin    of the frame of the vertices in that of the models, mm
    /// @param angle     surfaces whose normals differ by less than it (radians) count as one
    template <typename Operands>
    FaceIntersections(geometry::Engine& engine, const Operands& operands, const Vec3& origin, double angle,
                      const Progress* progress)
        : origin_(origin), angle_(angle), sessions_(operands.size()) {
        for (std::size_t i = 0; i < sessions_.size(); ++i) {
            if (operands[i].model) {
                sessions_[i].emplace(engine, operands[i].model, progress);
            }
        }
    }

    /// Projects each vertex onto each of its faces.
    /// @throws Cancelled
    void project(const std::vector<MovedVertex*>& vertices);
    /// Moves the vertices until each is nearer to its surfaces than `near`, mm, or lost, at most kNewtonSteps times.
    /// @param after_first  called when all were projected for the first time
    /// @throws Cancelled
    void approach(std::vector<MovedVertex>& vertices, double near, const std::function<void()>& after_first);
    /// Whether the face contains the point with the parameters of its last projection.
    bool contains(const SurfaceConstraint& face);

  private:
    Vec3 origin_;
    double angle_;
    std::vector<std::optional<geometry::Session>> sessions_;
};

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/points_on_faces.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "base/tuning.h"

namespace mq::boolean {

namespace {

/// The least displacement onto the intersection of the tangent planes of all surfaces.
Vec3 newton_step(const MovedVertex& moved, double angle) {
    const auto count = static_cast<Eigen::Index>(moved.surfaces.size());
    Eigen::Matrix<double, Eigen::Dynamic, 3> normals(count, 3);
    Eigen::VectorXd away(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const SurfaceConstraint& surface = moved.surfaces[static_cast<std::size_t>(i)];
        normals.row(i) = surface.normal.transpose();
        away[i] = surface.normal.dot(surface.foot - moved.now);
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, Eigen::Dynamic, 3>> solver;
    solver.setThreshold(angle);
    return solver.compute(normals).solve(away);
}

}  // namespace

double MovedVertex::distance() const {
    double largest = 0.0;
    for (const SurfaceConstraint& surface : surfaces) {
        largest = std::max(largest, surface.distance(now));
    }
    return largest;
}

void FaceIntersections::project(const std::vector<MovedVertex*>& vertices) {
    for (std::size_t operand = 0; operand < sessions_.size(); ++operand) {
        geometry::Engine::Batch batch;
        std::vector<std::pair<MovedVertex*, SurfaceConstraint*>> asked;
        for (MovedVertex* moved : vertices) {
            for (SurfaceConstraint& c : moved->surfaces) {
                if (c.face >= 0 && static_cast<std::size_t>(c.operand) == operand) {
                    const Vec3 p = moved->now + origin_;
                    asked.emplace_back(moved, &c);
                    batch.push_back(c.asked ? geometry::Query::face_nearest(c.face, p, c.u, c.v)
                                            : geometry::Query::face_nearest_global(c.face, p));
                }
            }
        }
        if (batch.empty()) {
            continue;
        }
        const geometry::Engine::Answers answers = sessions_[operand]->ask(std::move(batch));
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const auto& [moved, c] = asked[i];
            c->asked = answers[i].status == geometry::Status::Ok;
            moved->lost = moved->lost || !c->asked;
            if (c->asked) {
                c->foot = answers[i].point - origin_;
                c->normal = answers[i].normal;
                c->u = answers[i].u;
                c->v = answers[i].v;
            }
        }
    }
}

void FaceIntersections::approach(std::vector<MovedVertex>& vertices, double near,
                                 const std::function<void()>& after_first) {
    for (int step = 0; step <= kNewtonSteps; ++step) {
        std::vector<MovedVertex*> active;
        for (MovedVertex& moved : vertices) {
            if (step == 0 || (!moved.lost && moved.distance() > near)) {
                active.push_back(&moved);
            }
        }
        project(active);
        if (step == 0) {
            for (MovedVertex& moved : vertices) {
                moved.first_distance = moved.distance();
            }
            after_first();
        }
        for (MovedVertex* moved : active) {
            if (!moved->lost && step < kNewtonSteps && moved->distance() > near) {
                moved->now += newton_step(*moved, angle_);
                moved->lost = !((moved->now - moved->before).norm() <= 2.0 * moved->farthest);
            }
        }
    }
}

bool FaceIntersections::contains(const SurfaceConstraint& face) {
    return sessions_[static_cast<std::size_t>(face.operand)]
               ->ask(geometry::Query::face_contains(face.face, face.u, face.v))
               .side >= 0;
}

}  // namespace mq::boolean

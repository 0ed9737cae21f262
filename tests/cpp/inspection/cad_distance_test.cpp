// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/cad_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>

#include "geometry/analytic/analytic_model.h"
#include "inspection/deviation.h"
#include "triangulate/triangulate.h"

namespace mq::inspection {
namespace {

struct Solid {
    std::string name;
    std::shared_ptr<geometry::Model> model;
    std::function<double(const Vec3&)> distance;
};

/// The distance from a convex profile in the half plane of radius and height: its segments, with the inside on the
/// left.
double from_profile(double r, double z, const std::vector<Vec2>& corners) {
    double least = 1e300, inside = -1.0;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        const Vec2 along = corners[k + 1] - corners[k], way = Vec2(r, z) - corners[k];
        const double t = std::clamp(along.dot(way) / along.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (way - t * along).norm());
        inside = cross(along, way) < 0.0 ? 1.0 : inside;
    }
    return inside * least;
}

double radius_of(const Vec3& p) {
    return std::hypot(p.x(), p.y());
}

std::vector<Solid> solids_by_formula() {
    return {{"sphere", geometry::make_sphere(2.0), [](const Vec3& p) { return p.norm() - 2.0; }},
            {"cylinder", geometry::make_cylinder(2.0, 3.0),
             [](const Vec3& p) {
                 return from_profile(radius_of(p), p.z(), {Vec2(0, 0), Vec2(2, 0), Vec2(2, 3), Vec2(0, 3)});
             }},
            {"cone", geometry::make_cone(2.0, 3.0),
             [](const Vec3& p) {
                 return from_profile(radius_of(p), p.z(), {Vec2(0, 0), Vec2(2, 0), Vec2(0, 3)});
             }},
            {"torus", geometry::make_torus(3.0, 1.0),
             [](const Vec3& p) { return std::hypot(radius_of(p) - 3.0, p.z()) - 1.0; }},
            {"box", geometry::make_box(3.0, 2.0, 1.0), [](const Vec3& p) {
                 const Vec3 outside = (-p).cwiseMax(p - Vec3(3, 2, 1));
                 return outside.cwiseMax(0.0).norm() + std::min(outside.maxCoeff(), 0.0);
             }}};
}

TEST(CadDistance, IsThatOfTheFormulaOnCoarseMeshesToo) {
    for (const double relative : {0.02, 0.001}) {
        for (const Solid& solid : solids_by_formula()) {
            SCOPED_TRACE(solid.name);
            geometry::Engine engine(geometry::Engine::Mode::Direct);
            triangulate::TriangulateOptions options;
            options.chord_height_relative = relative;
            const triangulate::Result meshed = triangulate::triangulate(engine, solid.model, options);
            std::mt19937 random(1);
            std::uniform_real_distribution<double> place(-5.0, 5.0);
            std::vector<Vec3> points;
            for (int k = 0; k < 3000; ++k) {
                points.emplace_back(place(random), place(random), place(random));
            }
            // On the surface, and a little beside it.
            for (const Vec3& v : meshed.mesh.vertices) {
                points.push_back(v);
                points.push_back(v + 1e-3 * Vec3(place(random), place(random), place(random)));
            }
            geometry::Session session(engine, solid.model);
            Progress progress;
            const Deviation found = measure_deviation(points, meshed.mesh, &session,
                                                      2.0 * meshed.report.max_chord_height + 1e-6, {}, progress);
            EXPECT_EQ(found.by_mesh, 0u);
            for (std::size_t k = 0; k < points.size(); ++k) {
                const double expected = solid.distance(points[k]);
                EXPECT_NEAR(std::abs(found.distances[k].value), std::abs(expected), 1e-7) << points[k].transpose();
                if (std::abs(expected) > 1e-7) {
                    EXPECT_GT(found.distances[k].value * expected, 0.0) << points[k].transpose();
                }
                EXPECT_GE(found.distances[k].face, 0);
            }
        }
    }
}

TEST(CadDistance, IsCancelled) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    const std::shared_ptr<geometry::Model> model = geometry::make_sphere(1.0);
    const triangulate::Result meshed = triangulate::triangulate(engine, model, {});
    Progress progress;
    progress.cancel();
    geometry::Session session(engine, model, &progress);
    EXPECT_THROW(measure_deviation({Vec3(1, 2, 3)}, meshed.mesh, &session, 0.01, {}, progress), Cancelled);
}

}  // namespace
}  // namespace mq::inspection

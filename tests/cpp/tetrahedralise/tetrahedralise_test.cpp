// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/tetrahedralise.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <future>
#include <thread>

#include "base/parallel.h"
#include "base/predicates.h"
#include "tetrahedralise/cells/flips.h"
#include "tetrahedralise/closed_surfaces.h"
#include "tetrahedralise/is_bounded_by.h"

namespace mq::tetrahedralise {
namespace {

Tetrahedra tetrahedralised(const ClosedSurface& surface, double grading = 1.0) {
    return tetrahedralise(surface.points, surface.triangles, {grading, nullptr}, Progress());
}

/// All that is promised: exactly positive volumes, the surface's own triangles and no others outside, its volume.
Tetrahedra expect_tetrahedralised(const ClosedSurface& surface, double grading = 1.0) {
    Tetrahedra filling = tetrahedralised(surface, grading);
    std::vector<Vec3> points = surface.points;
    points.insert(points.end(), filling.inner_points.begin(), filling.inner_points.end());
    double sum = 0.0;
    for (const auto& t : filling.tetrahedra) {
        EXPECT_GT(orient3d(points[t[0]], points[t[1]], points[t[2]], points[t[3]]), 0);
        sum += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).dot(points[t[3]] - points[t[0]]) / 6.0;
    }
    EXPECT_TRUE(is_bounded_by(surface.triangles, filling.tetrahedra));
    EXPECT_NEAR(sum, surface.volume(), 1e-9 * surface.volume());
    return filling;
}

TEST(Tetrahedralise, BoxesWithManyPointsOnOnePlaneAndSphere) {
    for (const int n : {1, 2, 5, 12}) {
        expect_tetrahedralised(box(Vec3(1.0, 1.0, 1.0), n));
        expect_tetrahedralised(box(Vec3(0.1, 0.3, 0.7), n));
    }
}

TEST(Tetrahedralise, ABoxTurnedOffTheAxes) {
    ClosedSurface surface = box(Vec3(1.0, 2.0, 0.5), 6);
    const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()));
    for (Vec3& p : surface.points) {
        p = turn * p + Vec3(1000.0, -300.0, 20.0);
    }
    expect_tetrahedralised(surface);
}

TEST(Tetrahedralise, ThinPlates) {
    expect_tetrahedralised(box(Vec3(1.0, 1.0, 0.01), 8));
    expect_tetrahedralised(box(Vec3(1.0, 1.0, 1e-5), 8));
    expect_tetrahedralised(box(Vec3(1.0, 1e-3, 1e-3), 3));
}

TEST(Tetrahedralise, ASphereWithVoids) {
    ClosedSurface surface = sphere(1.0, 8);
    surface.add(sphere(0.95, 6).inverted());
    expect_tetrahedralised(surface);
    // A ball in the void, and in it a void once more.
    surface.add(sphere(0.5, 4));
    surface.add(box(Vec3(0.1, 0.1, 0.1), 1).inverted());
    expect_tetrahedralised(surface);
}

TEST(Tetrahedralise, ATorus) {
    expect_tetrahedralised(torus(1.0, 0.35, 30, 12));
    expect_tetrahedralised(torus(1.0, 0.05, 40, 5));
}

TEST(Tetrahedralise, SchoenhardtsPrismGetsAPointInside) {
    const std::size_t inside[2] = {expect_tetrahedralised(turned_prism(false)).inner_points.size(),
                                   expect_tetrahedralised(turned_prism(true)).inner_points.size()};
    EXPECT_GT(std::max(inside[0], inside[1]), 0u);
}

TEST(Tetrahedralise, RoughBalls) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        expect_tetrahedralised(
            rough_ball(4 + static_cast<int>(seed % 5), 0.1 * static_cast<double>(1 + seed % 7), seed));
    }
}

TEST(Tetrahedralise, SurfacesThatTouchThemselvesAtVerticesAndEdges) {
    ClosedSurface touching = box(Vec3(1.0, 1.0, 1.0), 3);
    for (const Vec3& way : {Vec3(1.0, 1.0, 0.0), Vec3(-1.0, -1.0, -1.0)}) {
        ClosedSurface other = box(Vec3(1.0, 1.0, 1.0), 3);
        for (Vec3& p : other.points) {
            p += way;
        }
        touching.add(other);
    }
    expect_tetrahedralised(touching);
    // Of two voids that touch, the inside lies around the point.
    ClosedSurface voids = box(Vec3(5.0, 5.0, 5.0), 1);
    for (const double at : {1.0, 2.0}) {
        ClosedSurface hole = box(Vec3(1.0, 1.0, 1.0), 1).inverted();
        for (Vec3& p : hole.points) {
            p += Vec3(at, at, at);
        }
        voids.add(hole);
    }
    EXPECT_THROW(tetrahedralised(voids), MeshingFailed);
}

TEST(Tetrahedralise, ThinSkinsNeedManyPointsOnTheSurface) {
    for (const auto& [thickness, n] : {std::pair(1e-3, 6), std::pair(3e-4, 10), std::pair(1e-2, 16)}) {
        ClosedSurface skin = sphere(1.0, n);
        ClosedSurface inner = skin.inverted();
        for (Vec3& p : inner.points) {
            p *= 1.0 - thickness;
        }
        skin.add(inner);
        expect_tetrahedralised(skin);
    }
}

TEST(Tetrahedralise, PointsOnTheSurfaceStayAwayFromItsVertices) {
    expect_tetrahedralised(rough_ball(11, 0.8, 1070));
    ClosedSurface wavy = box(Vec3(1.0, 1.0, 0.1), 10);
    for (Vec3& p : wavy.points) {
        p.z() += 0.05 * std::sin(9.0 * p.x()) * std::cos(7.0 * p.y());
    }
    expect_tetrahedralised(wavy);
}

TEST(Tetrahedralise, ASmallerFactorPutsMorePointsInside) {
    const ClosedSurface surface = sphere(1.0, 10);
    const std::size_t usual = expect_tetrahedralised(surface).inner_points.size();
    EXPECT_GT(expect_tetrahedralised(surface, 0.2).inner_points.size(), usual);
    EXPECT_GT(usual, 0u);
}

TEST(Tetrahedralise, TheAnglesOfASphereAreGood) {
    const ClosedSurface surface = sphere(1.0, 10);
    const Tetrahedra filling = expect_tetrahedralised(surface);
    std::vector<Vec3> points = surface.points;
    points.insert(points.end(), filling.inner_points.begin(), filling.inner_points.end());
    for (const auto& t : filling.tetrahedra) {
        EXPECT_GT(sine_quality(points[t[0]], points[t[1]], points[t[2]], points[t[3]]), std::sin(10.0 * M_PI / 180.0));
    }
}

TEST(Tetrahedralise, TheSameInputGivesTheSameBytes) {
    const ClosedSurface surface = rough_ball(6, 0.4, 3);
    const Tetrahedra first = tetrahedralised(surface);
    const Tetrahedra second = tetrahedralised(surface);
    EXPECT_EQ(first.tetrahedra, second.tetrahedra);
    EXPECT_EQ(first.inner_points, second.inner_points);
}

TEST(Tetrahedralise, WhatHasNoInsideIsRefused) {
    ClosedSurface open = box(Vec3(1.0, 1.0, 1.0), 2);
    open.triangles.pop_back();
    EXPECT_THROW(tetrahedralised(open), MeshingFailed);
    EXPECT_THROW(tetrahedralised(box(Vec3(1.0, 1.0, 1.0), 2).inverted()), MeshingFailed);
    ClosedSurface crossing = box(Vec3(1.0, 1.0, 1.0), 3);
    ClosedSurface other = box(Vec3(1.1, 0.5, 0.5), 2);
    for (Vec3& p : other.points) {
        p += Vec3(0.21, 0.13, 0.17);
    }
    crossing.add(other);
    EXPECT_THROW(tetrahedralised(crossing), MeshingFailed);
    ClosedSurface twice = box(Vec3(1.0, 1.0, 1.0), 2);
    twice.add(twice);
    EXPECT_THROW(tetrahedralised(twice), MeshingFailed);
}

TEST(Tetrahedralise, IsTheSameForAnyNumberOfThreads) {
    for (const ClosedSurface& surface : {sphere(1.0, 12), torus(3.0, 1.0, 40, 14), box(Vec3(1.0, 2.0, 0.1), 9)}) {
        const auto with = [&](int threads) {
            const ThreadLimit limit(threads);
            return tetrahedralised(surface);
        };
        const Tetrahedra one = with(1);
        for (const int threads : {2, 3, 8}) {
            const Tetrahedra several = with(threads);
            EXPECT_EQ(several.inner_points, one.inner_points) << threads;
            EXPECT_EQ(several.tetrahedra, one.tetrahedra) << threads;
        }
    }
}

TEST(Tetrahedralise, CanBeCancelledAtAnyTime) {
    const ClosedSurface surface = sphere(1.0, 20);
    for (const int threads : {1, 3}) {
        for (const int milliseconds : {0, 3, 10, 30}) {
            Progress progress;
            auto filling = std::async(std::launch::async, [&] {
                const ThreadLimit limit(threads);
                try {
                    tetrahedralise(surface.points, surface.triangles, {0.1, nullptr}, progress);
                } catch (const Cancelled&) {
                    return true;
                }
                return false;
            });
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            progress.cancel();
            EXPECT_TRUE(filling.get()) << threads << " " << milliseconds;
        }
    }
}

}  // namespace
}  // namespace mq::tetrahedralise

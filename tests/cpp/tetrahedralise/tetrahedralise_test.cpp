// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/filling/surface_filling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <future>
#include <thread>

#include "base/parallel.h"
#include "base/predicates.h"
#include "curve/volume/filling/cells/flips.h"
#include "curve/volume/filling/closed_surfaces.h"
#include "curve/volume/filling/filling_check.h"

namespace mq::curve {
namespace {

TetrahedralFilling filled(const ClosedSurface& surface, double grading = 1.0) {
    return fill_surface(surface.points, surface.triangles, grading, Progress());
}

/// All that is promised: exactly positive volumes, the surface's own triangles and no others outside, its volume.
TetrahedralFilling expect_filled(const ClosedSurface& surface, double grading = 1.0) {
    TetrahedralFilling filling = filled(surface, grading);
    std::vector<Vec3> points = surface.points;
    points.insert(points.end(), filling.inner_points.begin(), filling.inner_points.end());
    double sum = 0.0;
    for (const auto& t : filling.tetrahedra) {
        EXPECT_GT(orient3d(points[t[0]], points[t[1]], points[t[2]], points[t[3]]), 0);
        sum += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).dot(points[t[3]] - points[t[0]]) / 6.0;
    }
    EXPECT_TRUE(ends_at(surface.triangles, filling.tetrahedra));
    EXPECT_NEAR(sum, surface.volume(), 1e-9 * surface.volume());
    return filling;
}

TEST(SurfaceFilling, BoxesWithManyPointsOnOnePlaneAndSphere) {
    for (const int n : {1, 2, 5, 12}) {
        expect_filled(box(Vec3(1.0, 1.0, 1.0), n));
        expect_filled(box(Vec3(0.1, 0.3, 0.7), n));
    }
}

TEST(SurfaceFilling, ABoxTurnedOffTheAxes) {
    ClosedSurface surface = box(Vec3(1.0, 2.0, 0.5), 6);
    const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()));
    for (Vec3& p : surface.points) {
        p = turn * p + Vec3(1000.0, -300.0, 20.0);
    }
    expect_filled(surface);
}

TEST(SurfaceFilling, ThinPlates) {
    expect_filled(box(Vec3(1.0, 1.0, 0.01), 8));
    expect_filled(box(Vec3(1.0, 1.0, 1e-5), 8));
    expect_filled(box(Vec3(1.0, 1e-3, 1e-3), 3));
}

TEST(SurfaceFilling, ASphereWithVoids) {
    ClosedSurface surface = sphere(1.0, 8);
    surface.add(sphere(0.95, 6).inverted());
    expect_filled(surface);
    // A ball in the void, and in it a void once more.
    surface.add(sphere(0.5, 4));
    surface.add(box(Vec3(0.1, 0.1, 0.1), 1).inverted());
    expect_filled(surface);
}

TEST(SurfaceFilling, ATorus) {
    expect_filled(torus(1.0, 0.35, 30, 12));
    expect_filled(torus(1.0, 0.05, 40, 5));
}

TEST(SurfaceFilling, SchoenhardtsPrismGetsAPointInside) {
    const std::size_t inside[2] = {expect_filled(turned_prism(false)).inner_points.size(),
                                   expect_filled(turned_prism(true)).inner_points.size()};
    EXPECT_GT(std::max(inside[0], inside[1]), 0u);
}

TEST(SurfaceFilling, RoughBalls) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        expect_filled(rough_ball(4 + static_cast<int>(seed % 5), 0.1 * static_cast<double>(1 + seed % 7), seed));
    }
}

TEST(SurfaceFilling, SurfacesThatTouchThemselvesAtVerticesAndEdges) {
    ClosedSurface touching = box(Vec3(1.0, 1.0, 1.0), 3);
    for (const Vec3& way : {Vec3(1.0, 1.0, 0.0), Vec3(-1.0, -1.0, -1.0)}) {
        ClosedSurface other = box(Vec3(1.0, 1.0, 1.0), 3);
        for (Vec3& p : other.points) {
            p += way;
        }
        touching.add(other);
    }
    expect_filled(touching);
    // Of two voids that touch, the inside lies around the point.
    ClosedSurface voids = box(Vec3(5.0, 5.0, 5.0), 1);
    for (const double at : {1.0, 2.0}) {
        ClosedSurface hole = box(Vec3(1.0, 1.0, 1.0), 1).inverted();
        for (Vec3& p : hole.points) {
            p += Vec3(at, at, at);
        }
        voids.add(hole);
    }
    EXPECT_THROW(filled(voids), MeshingFailed);
}

TEST(SurfaceFilling, ThinSkinsNeedManyPointsOnTheSurface) {
    for (const auto& [thickness, n] : {std::pair(1e-3, 6), std::pair(3e-4, 10), std::pair(1e-2, 16)}) {
        ClosedSurface skin = sphere(1.0, n);
        ClosedSurface inner = skin.inverted();
        for (Vec3& p : inner.points) {
            p *= 1.0 - thickness;
        }
        skin.add(inner);
        expect_filled(skin);
    }
}

TEST(SurfaceFilling, PointsOnTheSurfaceStayAwayFromItsVertices) {
    expect_filled(rough_ball(11, 0.8, 1070));
    ClosedSurface wavy = box(Vec3(1.0, 1.0, 0.1), 10);
    for (Vec3& p : wavy.points) {
        p.z() += 0.05 * std::sin(9.0 * p.x()) * std::cos(7.0 * p.y());
    }
    expect_filled(wavy);
}

TEST(SurfaceFilling, ASmallerFactorPutsMorePointsInside) {
    const ClosedSurface surface = sphere(1.0, 10);
    const std::size_t usual = expect_filled(surface).inner_points.size();
    EXPECT_GT(expect_filled(surface, 0.2).inner_points.size(), usual);
    EXPECT_GT(usual, 0u);
}

TEST(SurfaceFilling, TheAnglesOfASphereAreGood) {
    const ClosedSurface surface = sphere(1.0, 10);
    const TetrahedralFilling filling = expect_filled(surface);
    std::vector<Vec3> points = surface.points;
    points.insert(points.end(), filling.inner_points.begin(), filling.inner_points.end());
    for (const auto& t : filling.tetrahedra) {
        EXPECT_GT(sine_quality(points[t[0]], points[t[1]], points[t[2]], points[t[3]]), std::sin(10.0 * M_PI / 180.0));
    }
}

TEST(SurfaceFilling, TheSameInputGivesTheSameBytes) {
    const ClosedSurface surface = rough_ball(6, 0.4, 3);
    const TetrahedralFilling first = filled(surface);
    const TetrahedralFilling second = filled(surface);
    EXPECT_EQ(first.tetrahedra, second.tetrahedra);
    EXPECT_EQ(first.inner_points, second.inner_points);
}

TEST(SurfaceFilling, WhatHasNoInsideIsRefused) {
    ClosedSurface open = box(Vec3(1.0, 1.0, 1.0), 2);
    open.triangles.pop_back();
    EXPECT_THROW(filled(open), MeshingFailed);
    EXPECT_THROW(filled(box(Vec3(1.0, 1.0, 1.0), 2).inverted()), MeshingFailed);
    ClosedSurface crossing = box(Vec3(1.0, 1.0, 1.0), 3);
    ClosedSurface other = box(Vec3(1.1, 0.5, 0.5), 2);
    for (Vec3& p : other.points) {
        p += Vec3(0.21, 0.13, 0.17);
    }
    crossing.add(other);
    EXPECT_THROW(filled(crossing), MeshingFailed);
    ClosedSurface twice = box(Vec3(1.0, 1.0, 1.0), 2);
    twice.add(twice);
    EXPECT_THROW(filled(twice), MeshingFailed);
}

TEST(SurfaceFilling, IsTheSameForAnyNumberOfThreads) {
    for (const ClosedSurface& surface : {sphere(1.0, 12), torus(3.0, 1.0, 40, 14), box(Vec3(1.0, 2.0, 0.1), 9)}) {
        const auto with = [&](int threads) {
            const ThreadLimit limit(threads);
            return filled(surface);
        };
        const TetrahedralFilling one = with(1);
        for (const int threads : {2, 3, 8}) {
            const TetrahedralFilling several = with(threads);
            EXPECT_EQ(several.inner_points, one.inner_points) << threads;
            EXPECT_EQ(several.tetrahedra, one.tetrahedra) << threads;
        }
    }
}

TEST(SurfaceFilling, CanBeCancelledAtAnyTime) {
    const ClosedSurface surface = sphere(1.0, 20);
    for (const int threads : {1, 3}) {
        for (const int milliseconds : {0, 3, 10, 30}) {
            Progress progress;
            auto filling = std::async(std::launch::async, [&] {
                const ThreadLimit limit(threads);
                try {
                    fill_surface(surface.points, surface.triangles, 0.1, progress);
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
}  // namespace mq::curve

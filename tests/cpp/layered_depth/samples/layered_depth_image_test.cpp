// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/layered_depth_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "boolean/closed_solids.h"
#include "layered_depth/samples/rasterise.h"

namespace mq::layered_depth {

namespace solids = boolean::solids;
namespace {

Box box_of(const OperandSet& pair) {
    Box box;
    for (const Vec3& p : pair.points) {
        box.add(p);
    }
    return box;
}

/// Every ray enters as often as it leaves; returns the samples of all rays.
std::size_t expect_balance(const LayeredDepthSet& set, const SampleGrid& grid) {
    std::size_t count = 0;
    for (const LayeredDepthImage& direction : set) {
        EXPECT_EQ(direction.begin.size(), static_cast<std::size_t>(grid.rays()) * grid.rays() + 1);
        EXPECT_EQ(direction.begin.back(), direction.depth.size());
        for (std::size_t ray = 0; ray + 1 < direction.begin.size(); ++ray) {
            int balance = 0;
            for (std::uint32_t i = direction.begin[ray]; i < direction.begin[ray + 1]; ++i) {
                balance += direction.code[i] < 0 ? -1 : 1;
                EXPECT_TRUE(i == direction.begin[ray] || direction.depth[i - 1] <= direction.depth[i]);
            }
            EXPECT_EQ(balance, 0) << "ray " << ray;
        }
        count += direction.depth.size();
    }
    return count;
}

TEST(SampleGrid, HoldsTheBoxInPowerOfTwoCells) {
    Box box;
    box.add(Vec3(-3, 2, 7));
    box.add(Vec3(5, 3, 8));
    const SampleGrid grid(box, 100);
    EXPECT_EQ(grid.rays(), 129);
    EXPECT_EQ(1 << grid.levels(), grid.cells());
    for (const Vec3& p : {box.low, box.high}) {
        EXPECT_TRUE((grid.to_grid(p).array() > 1.0).all());
        EXPECT_TRUE((grid.to_grid(p).array() < grid.cells() - 1.0).all());
        EXPECT_LT((grid.to_space(grid.to_grid(p)) - p).norm(), 1e-14);
    }
}

TEST(Rasterise, SamplesLieOnTheirTriangles) {
    const OperandSet pair(solids::sphere(Vec3(0.3, 0.2, 0.1), 1.0, 12, 0.2), mesh::TriangleMesh());
    const SampleGrid grid(box_of(pair), 65);
    const LayeredDepthSet set = rasterise(pair, 0, grid, nullptr);
    EXPECT_GT(expect_balance(set, grid), 15000U);
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t ray = 0; ray + 1 < set[axis].begin.size(); ++ray) {
            for (std::uint32_t i = set[axis].begin[ray]; i < set[axis].begin[ray + 1]; ++i) {
                const std::int32_t code = set[axis].code[i];
                const mesh::Triangle& t = pair.triangles[code < 0 ? ~code : code];
                Vec3 g;
                g[axis] = set[axis].depth[i];
                g[(axis + 1) % 3] = static_cast<double>(ray % grid.rays());
                g[(axis + 2) % 3] = static_cast<double>(ray / grid.rays());
                const Vec3 p = grid.to_space(g), a = pair.points[t[0]];
                const Vec3 n = (pair.points[t[1]] - a).cross(pair.points[t[2]] - a).normalized();
                ASSERT_NEAR((p - a).dot(n), 0.0, 1e-7);
                EXPECT_EQ(code<0, n[axis]> 0.0);
            }
        }
    }
}

/// Vertices exactly on rays and nodes, edges along rays: the worst for an inconsistent rule.
TEST(Rasterise, RaysThroughVerticesAndEdgesCountOnce) {
    const OperandSet frame(solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), mesh::TriangleMesh());
    const SampleGrid grid(box_of(frame), 33);
    std::mt19937 random(7);
    for (int round = 0; round < 40; ++round) {
        mesh::TriangleMesh solid = round % 2 == 0 ? solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1))
                                                  : solids::sphere(Vec3(0.5, 0.5, 0.5), 0.5, 2 + round / 4);
        for (Vec3& p : solid.vertices) {
            Vec3 g = grid.to_grid(p).array().round();
            if (round % 3 == 0) {
                g[static_cast<int>(random() % 3)] += 0.5;
            }
            p = grid.to_space(g);
        }
        expect_balance(rasterise(OperandSet(solid, mesh::TriangleMesh()), 0, grid, nullptr), grid);
        expect_balance(rasterise(OperandSet(mesh::TriangleMesh(), solid), 1, grid, nullptr), grid);
    }
}

TEST(Rasterise, DegenerateTrianglesKeepTheBalance) {
    mesh::TriangleMesh solid = solids::sphere(Vec3(0, 0, 0), 1.0, 10);
    std::mt19937 random(3);
    for (int k = 0; k < 60; ++k) {
        solid.vertices[random() % solid.vertices.size()] = solid.vertices[random() % solid.vertices.size()];
    }
    const OperandSet pair(solid, mesh::TriangleMesh());
    const SampleGrid grid(box_of(pair), 65);
    expect_balance(rasterise(pair, 0, grid, nullptr), grid);
}

TEST(Rasterise, OperandsBeyondTheGridKeepTheBalance) {
    const OperandSet frame(solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), mesh::TriangleMesh());
    const SampleGrid grid(box_of(frame), 33);
    for (const double radius : {0.9, 2.0, 50.0, 1e4, 1e9}) {
        const mesh::TriangleMesh ball = solids::sphere(Vec3(0.3, 0.4, 0.5 - 0.99 * radius), radius, 40);
        const OperandSet pair(ball, mesh::TriangleMesh());
        EXPECT_GT(expect_balance(rasterise(pair, 0, grid, nullptr), grid), 1000U) << radius;
    }
}

/// Positions of all samples of a set.
std::vector<Vec3> positions(const LayeredDepthSet& set, const SampleGrid& grid) {
    std::vector<Vec3> found;
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t ray = 0; ray + 1 < set[axis].begin.size(); ++ray) {
            for (std::uint32_t i = set[axis].begin[ray]; i < set[axis].begin[ray + 1]; ++i) {
                Vec3 g;
                g[axis] = set[axis].depth[i];
                g[(axis + 1) % 3] = static_cast<double>(ray % grid.rays());
                g[(axis + 2) % 3] = static_cast<double>(ray / grid.rays());
                found.push_back(grid.to_space(g));
            }
        }
    }
    return found;
}

/// The largest distance of points of a surface (corners and middles of its triangles) from the nearest sample, in units
/// of r.
double covering(const mesh::TriangleMesh& mesh, int resolution) {
    const OperandSet pair(mesh, mesh::TriangleMesh());
    const SampleGrid grid(box_of(pair), resolution);
    const std::vector<Vec3> samples = positions(rasterise(pair, 0, grid, nullptr), grid);
    double largest = 0.0;
    const auto examine = [&](const Vec3& p) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& sample : samples) {
            nearest = std::min(nearest, (sample - p).squaredNorm());
        }
        largest = std::max(largest, std::sqrt(nearest) / grid.spacing());
    };
    for (const mesh::Triangle& t : mesh.triangles) {
        examine(mesh.vertices[t[0]]);
        examine((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0);
    }
    return largest;
}

/// The lemma of section IV-A: every point of the surface has a sample within sqrt(3) r.
TEST(Rasterise, SamplesCoverSolidsThatAreThickerThanTheSpacing) {
    for (const int resolution : {33, 65}) {
        SCOPED_TRACE(resolution);
        EXPECT_LE(covering(solids::sphere(Vec3(0.3, 0.2, 0.1), 1.0, 24), resolution), std::sqrt(3.0));
        EXPECT_LE(covering(solids::sphere(Vec3(0.3, 0.2, 0.1), 1.0, 12, 0.2), resolution), std::sqrt(3.0));
        EXPECT_LE(covering(solids::box(Vec3(0, 0, 0), Vec3(1.0, 0.6, 0.33)), resolution), std::sqrt(3.0));
    }
}

/// Its proof takes a surface that passes the edges of a cell. The tip of a needle thinner than r passes none: there the
/// lemma does not hold, and neither does the bound of a result.
TEST(Rasterise, SamplesDoNotCoverNeedlesThinnerThanTheSpacing) {
    mesh::TriangleMesh spiked = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const auto tip = static_cast<std::int32_t>(spiked.vertices.size());
    spiked.vertices.push_back(Vec3(1.5, 0.515, 0.515));
    // The needle is a pyramid that begins inside of the box.
    for (const Vec3& p : {Vec3(0.9, 0.51, 0.51), Vec3(0.9, 0.52, 0.51), Vec3(0.9, 0.51, 0.52)}) {
        spiked.vertices.push_back(p);
    }
    const std::int32_t a = tip + 1, b = tip + 2, c = tip + 3;
    spiked.triangles.insert(spiked.triangles.end(), {{a, c, b}, {tip, a, b}, {tip, b, c}, {tip, c, a}});
    const double at_33 = covering(spiked, 33), at_513 = covering(spiked, 513);
    EXPECT_GT(at_33, 4.0 * std::sqrt(3.0));
    // Finer rays leave a shorter tip uncovered.
    EXPECT_LT(at_513 / 512, at_33 / 32);
}

TEST(Rasterise, StopsWhenCancelled) {
    const OperandSet pair(solids::sphere(Vec3(0, 0, 0), 1.0, 20), mesh::TriangleMesh());
    Progress progress;
    progress.cancel();
    EXPECT_THROW(rasterise(pair, 0, SampleGrid(box_of(pair), 65), &progress), Cancelled);
}

}  // namespace
}  // namespace mq::layered_depth

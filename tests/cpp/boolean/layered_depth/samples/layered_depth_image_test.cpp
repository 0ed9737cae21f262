// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/layered_depth/samples/layered_depth_image.h"

#include <gtest/gtest.h>

#include "boolean/closed_solids.h"
#include "boolean/layered_depth/samples/rasterise.h"

namespace mq::boolean {
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

TEST(Rasterise, StopsWhenCancelled) {
    const OperandSet pair(solids::sphere(Vec3(0, 0, 0), 1.0, 20), mesh::TriangleMesh());
    Progress progress;
    progress.cancel();
    EXPECT_THROW(rasterise(pair, 0, SampleGrid(box_of(pair), 65), &progress), Cancelled);
}

}  // namespace
}  // namespace mq::boolean

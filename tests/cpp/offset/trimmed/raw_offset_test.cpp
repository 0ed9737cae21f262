// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/trimmed/raw_offset.h"

#include <gtest/gtest.h>

#include "boolean/closed_solids.h"
#include "mesh/corner_table.h"

namespace mq::offset {

namespace solids = boolean::solids;
namespace {

ClosedSurface surface_of(const mesh::TriangleMesh& mesh) {
    ClosedSurface surface{mesh.vertices, mesh.triangles, mesh::edge_twins(mesh.triangles, mesh.vertices.size()), {}};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        surface.source.push_back(static_cast<std::int32_t>(t));
    }
    return surface;
}

RawOffset raw_of(const mesh::TriangleMesh& mesh, double distance, double tolerance) {
    const ClosedSurface surface = surface_of(mesh);
    const mesh::SearchedSurface searched(surface.points, surface.triangles);
    return raw_offset(surface, {distance, tolerance, 0.0, distance - tolerance, &searched});
}

TEST(RawOffset, IsClosedAndAtTheDistance) {
    const mesh::TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 8, 6));
    const RawOffset raw = raw_of(box, 1.5, 0.01);
    for (const std::int32_t twin : mesh::edge_twins(raw.triangles, raw.vertices.size())) {
        EXPECT_GE(twin, 0);
    }
    const mesh::NearestTree tree(box.vertices, box.triangles);
    for (const Vec3& p : raw.vertices) {
        const double distance = tree.nearest(p).distance;
        EXPECT_TRUE(std::abs(distance - 1.5) < 1e-5 || distance == 0.0);  // its own places are there, unused
    }
    for (const mesh::Triangle& t : raw.triangles) {
        const Vec3 middle =
            (raw.vertices[static_cast<std::size_t>(t[0])] + raw.vertices[static_cast<std::size_t>(t[1])] +
             raw.vertices[static_cast<std::size_t>(t[2])]) /
            3.0;
        EXPECT_NEAR(tree.nearest(middle).distance, 1.5, 0.01 + 1e-5);
    }
}

TEST(RawOffset, AFinerToleranceTakesMoreTriangles) {
    const mesh::TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 8, 6));
    EXPECT_GT(raw_of(box, 1.5, 0.001).triangles.size(), 4 * raw_of(box, 1.5, 0.01).triangles.size());
}

TEST(RawOffset, OneDirectionAtAVertexOfASmoothSurface) {
    const mesh::TriangleMesh ball = solids::sphere(Vec3(0, 0, 0), 5.0, 30);
    EXPECT_EQ(raw_of(ball, 0.5, 0.01).triangles.size(), ball.triangles.size());
    // Without a tolerance its edges are edges: strips round them off.
    EXPECT_GT(raw_of(ball, 0.5, 1e-6).triangles.size(), 3 * ball.triangles.size());
}

TEST(RawOffset, FollowsNormalsOfFaces) {
    // The vertices of a ball lie on the sphere, but the mean of the normals of the triangles around one is not radial.
    const mesh::TriangleMesh ball = solids::sphere(Vec3(0, 0, 0), 5.0, 12);
    ClosedSurface surface = surface_of(ball);
    const auto off_sphere = [&] {
        const mesh::SearchedSurface searched(surface.points, surface.triangles);
        const RawOffset raw = raw_offset(surface, {4.9, 0.15, 0.4, 4.5, &searched});
        EXPECT_EQ(raw.triangles.size(), ball.triangles.size());
        double most = 0.0;
        for (std::size_t t = 0; t < raw.triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& base = ball.vertices[static_cast<std::size_t>(ball.triangles[t][k])];
                const Vec3& moved = raw.vertices[static_cast<std::size_t>(raw.triangles[t][k])];
                most = std::max(most, (moved - base * (9.9 / base.norm())).norm());
            }
        }
        return most;
    };
    EXPECT_GT(off_sphere(), 0.05);
    for (const mesh::Triangle& t : ball.triangles) {
        for (const std::int32_t v : t) {
            surface.normals.push_back(ball.vertices[static_cast<std::size_t>(v)].normalized());
        }
    }
    EXPECT_LT(off_sphere(), 1e-5);
}

TEST(RawOffset, WhatIsOffsetFromANarrowSlotStaysOnTheSurface) {
    // A slot of 0.2 in a block, offset by 2: between its sides nothing is 2 away.
    mesh::TriangleMesh block = solids::box(Vec3(0, 0, 0), Vec3(20, 20, 20));
    mesh::TriangleMesh inside = solids::box(Vec3(9.9, 5, 5), Vec3(10.1, 15, 15));
    for (mesh::Triangle& t : inside.triangles) {
        block.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
    }
    block.vertices.insert(block.vertices.end(), inside.vertices.begin(), inside.vertices.end());
    const RawOffset raw = raw_of(block, 2.0, 0.02);
    std::size_t on_slot = 0;
    for (std::size_t t = 0; t < raw.triangles.size(); ++t) {
        if (raw.source[t] >= 12) {
            for (const std::int32_t v : raw.triangles[t]) {
                EXPECT_LT((raw.vertices[static_cast<std::size_t>(v)] - Vec3(10, 10, 10)).cwiseAbs().maxCoeff(),
                          5.0 + 1e-6);
            }
            ++on_slot;
        }
    }
    EXPECT_GT(on_slot, 0U);
}

}  // namespace
}  // namespace mq::offset

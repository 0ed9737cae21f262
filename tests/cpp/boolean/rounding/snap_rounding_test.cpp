// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/snap_rounding.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "boolean/boolean.h"
#include "boolean/random_meshes.h"
#include "mesh/quality/surface_verification.h"

namespace mq::boolean {
namespace {

/// A turned cylinder whose side is made of `count` pairs of needles.
mesh::TriangleMesh needles(int count, double turn) {
    mesh::TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const double u = 2.0 * M_PI * i / count;
        mesh.vertices.emplace_back(0.3 * std::cos(u), 0.3 * std::sin(u), -1.0);
        mesh.vertices.emplace_back(0.3 * std::cos(u), 0.3 * std::sin(u), 1.0);
    }
    for (int i = 0; i < count; ++i) {
        const int a = 2 * i;
        const int b = 2 * ((i + 1) % count);
        mesh.triangles.push_back({a, b, b + 1});
        mesh.triangles.push_back({a, b + 1, a + 1});
        if (i > 0 && i + 1 < count) {
            mesh.triangles.push_back({0, b, a});
            mesh.triangles.push_back({1, a + 1, b + 1});
        }
    }
    const Eigen::AngleAxisd rotation(turn, Vec3(1, 2, 3).normalized());
    for (Vec3& p : mesh.vertices) {
        p = to_single(rotation * p);
    }
    return mesh;
}

/// The intersection curves of needles have points nearer to each other and to edges than single precision tells apart.
TEST(SnapRounding, CrossingNeedlesStaySound) {
    const mesh::TriangleMesh a = needles(700, 0.3);
    const mesh::TriangleMesh b = needles(900, 1.1);
    double volume[3];
    for (const Operation operation : {Operation::Union, Operation::Intersection, Operation::Difference}) {
        const BooleanResult result = boolean({&a, &b}, operation, {});
        const mesh::Verification check = mesh::verify(result.mesh.vertices, result.mesh.triangles);
        EXPECT_TRUE(check.passed()) << name(operation) << ": " << check.summary();
        EXPECT_EQ(result.faults_left, 0u);
        EXPECT_LT(result.error_bound, 1e-4);
        volume[static_cast<int>(operation)] = check.volume;
    }
    const double sum = fuzz::signed_volume(a.vertices, a.triangles) + fuzz::signed_volume(b.vertices, b.triangles);
    EXPECT_NEAR(volume[0] + volume[1], sum, 1e-5 * sum);
}

/// A sound surface is left as it is.
TEST(SnapRounding, ASoundSurfaceIsLeftAlone) {
    Extraction extraction;
    const mesh::TriangleMesh cube = fuzz::cube(1);
    extraction.draft.vertices = cube.vertices;
    extraction.draft.made.assign(cube.vertices.size(), kConstructed);
    extraction.draft.triangles = cube.triangles;
    extraction.draft.source.resize(cube.triangles.size());
    extraction.draft.from.assign(cube.triangles.size(), 0);
    extraction.draft.displacement.assign(cube.triangles.size(), 0.0);
    const RoundingCount count = snap_round(extraction, {1.0, 1e-3, true}, Progress());
    EXPECT_EQ(count.rounds, 0u);
    EXPECT_TRUE(count.faulty.empty());
    EXPECT_EQ(extraction.draft.triangles, cube.triangles);
    EXPECT_EQ(count.error_bound, 0.0);
}

/// A tetrahedron thinner than single precision vanishes, as the space that it encloses does.
TEST(SnapRounding, WhatIsThinnerThanThePrecisionVanishes) {
    Extraction extraction;
    ResultMesh& draft = extraction.draft;
    draft.vertices = {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1.2, 1.2, 1 + 1e-9}};
    draft.made.assign(4, kConstructed);
    draft.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    draft.source.resize(4);
    draft.from.assign(4, 0);
    draft.displacement.assign(4, 0.0);
    const RoundingCount count = snap_round(extraction, {1.0, 1e-3, true}, Progress());
    EXPECT_TRUE(count.faulty.empty());
    EXPECT_TRUE(draft.triangles.empty());
}

}  // namespace
}  // namespace mq::boolean

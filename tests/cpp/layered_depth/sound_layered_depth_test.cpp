// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/sound_layered_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "boolean/closed_solids.h"
#include "boolean/random_meshes.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/surface_winding.h"
#include "mesh/quality/surface_verification.h"

namespace mq::layered_depth {

namespace fuzz = boolean::fuzz;
namespace solids = boolean::solids;

using boolean::Operation;

namespace {

using mesh::TriangleMesh;

UniformResult sound(const TriangleMesh& a, const TriangleMesh& b, Operation operation, int resolution) {
    Box box;
    for (const TriangleMesh* mesh : {&a, &b}) {
        for (const Vec3& p : mesh->vertices) {
            box.add(p);
        }
    }
    LayeredDepthOptions options;
    options.resolution = resolution;
    Progress progress;
    return sound_layered_depth_boolean({&a, &b}, boolean::Expression::chain(operation, 2), options,
                                       uniform_bound(box.largest_side(), resolution), progress);
}

void expect_own_triangles(const UniformResult& result, const std::vector<const TriangleMesh*>& operands) {
    std::size_t retained = 0;
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        const auto [operand, triangle] = result.triangle_source[t];
        if (operand < 0) {
            continue;
        }
        ++retained;
        const TriangleMesh& own = *operands[static_cast<std::size_t>(operand)];
        const mesh::Triangle& corners = own.triangles[static_cast<std::size_t>(triangle)];
        for (const std::int32_t v : result.mesh.triangles[t]) {
            EXPECT_TRUE(std::any_of(corners.begin(), corners.end(),
                                    [&](std::int32_t w) {
                                        return own.vertices[static_cast<std::size_t>(w)] ==
                                               result.mesh.vertices[static_cast<std::size_t>(v)];
                                    }))
                << "triangle " << t;
        }
    }
    EXPECT_EQ(retained, result.retained);
}

/// A ball with folds narrower than the distance between rays: one vertex is drawn across its neighbours.
TriangleMesh folded_ball() {
    TriangleMesh ball = solids::sphere(Vec3(0, 0, 0), 1.0, 40);
    ball.vertices[900] = to_single(ball.vertices[900] + 1.7 * (ball.vertices[902] - ball.vertices[900]));
    ball.vertices[1500] = to_single(1.02 * ball.vertices[1502]);
    return ball;
}

TEST(SoundLayeredDepth, TrianglesOfOperandsThatCrossAreDivided) {
    const TriangleMesh a = folded_ball();
    const TriangleMesh b = solids::sphere(Vec3(5, 0, 0), 1.0, 20);
    LayeredDepthOptions options;
    options.resolution = 65;
    const UniformResult scheme = layered_depth_boolean(a, b, Operation::Union, options, nullptr);
    ASSERT_GT(mesh::verify(scheme.mesh.vertices, scheme.mesh.triangles)
                  .count[static_cast<std::size_t>(mesh::FaultKind::Crossing)],
              0U);  // the paper's scheme keeps them
    const UniformResult result = sound(a, b, Operation::Union, 65);
    const mesh::Verification check = mesh::verify(result.mesh.vertices, result.mesh.triangles);
    EXPECT_TRUE(check.passed()) << check.summary();
    EXPECT_GT(result.crossing_pairs, 0U);
    EXPECT_GT(result.retained, scheme.retained * 9 / 10);
    expect_own_triangles(result, {&a, &b});
    const double whole = mesh::verify(b.vertices, b.triangles).volume;
    EXPECT_NEAR(check.volume,
                whole + mesh::verify(solids::sphere(Vec3(0, 0, 0), 1.0, 40).vertices,
                                     solids::sphere(Vec3(0, 0, 0), 1.0, 40).triangles)
                            .volume,
                0.01);
}

TEST(SoundLayeredDepth, SoundResultsStayAsTheyAre) {
    const TriangleMesh a = solids::sphere(Vec3(0, 0, 0), 1.0, 24);
    const TriangleMesh b = solids::sphere(Vec3(3, 0, 0), 1.0, 24);
    LayeredDepthOptions options;
    options.resolution = 65;
    const UniformResult scheme = layered_depth_boolean(a, b, Operation::Union, options, nullptr);
    const UniformResult result = sound(a, b, Operation::Union, 65);
    EXPECT_EQ(result.mesh.vertices, scheme.mesh.vertices);
    EXPECT_EQ(result.mesh.triangles, scheme.mesh.triangles);
    EXPECT_EQ(result.crossing_pairs, 0U);
    EXPECT_EQ(result.error_bound, 0.0);
}

/// Whether points of space are in the result where they are in the exact one, by winding numbers, which share no code
/// with the arrangement: all that are farther from the result than its error bound.
void expect_points_agree(const fuzz::Pair& pair, Operation operation, const UniformResult& result) {
    const mesh::SurfaceWinding in_result(result.mesh.vertices, result.mesh.triangles);
    const mesh::SurfaceWinding in_a(pair.a.vertices, pair.a.triangles);
    const mesh::SurfaceWinding in_b(pair.b.vertices, pair.b.triangles);
    const mesh::NearestTree tree(result.mesh.vertices, result.mesh.triangles);
    fuzz::Random random(7);
    for (int k = 0; k < 200; ++k) {
        const Vec3 p(random.real(-2, 2), random.real(-2, 2), random.real(-2, 2));
        if (tree.nearest(p).distance > result.error_bound + 1e-3) {
            EXPECT_EQ(in_result.at(p) > 0.5, boolean::in_result(operation, in_a.at(p) > 0.5, in_b.at(p) > 0.5));
        }
    }
}

TEST(SoundLayeredDepth, RandomPairsAreSoundAndEncloseTheRightPoints) {
    std::size_t crossed = 0;
    for (const std::uint64_t seed : {0U, 2U, 8U, 9U, 12U, 22U, 32U, 34U, 115U}) {
        for (const bool dirty : {false, true}) {
            const fuzz::Pair pair = dirty ? fuzz::dirty_pair(seed) : fuzz::random_pair(seed);
            for (const Operation operation : {Operation::Union, Operation::Difference}) {
                SCOPED_TRACE(pair.description + ", " + boolean::name(operation));
                const UniformResult result = sound(pair.a, pair.b, operation, 33);
                const mesh::Verification check = mesh::verify(result.mesh.vertices, result.mesh.triangles);
                EXPECT_TRUE(check.passed()) << check.summary();
                crossed += result.crossing_pairs;
                if (pair.clean && !dirty) {
                    expect_points_agree(pair, operation, result);
                }
            }
        }
    }
    EXPECT_GT(crossed, 100U);
}

}  // namespace
}  // namespace mq::layered_depth

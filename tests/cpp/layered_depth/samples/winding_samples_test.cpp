// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/winding_samples.h"

#include <gtest/gtest.h>

#include <utility>

#include "boolean/closed_solids.h"
#include "layered_depth/samples/rasterise.h"

namespace mq::layered_depth {

namespace solids = boolean::solids;
namespace {

/// An operand that is sampled by its winding number, and how its rays compare with that number at all nodes.
struct Sampled {
    Sampled(mesh::TriangleMesh given, int resolution)
        : mesh(std::move(given)),
          winding(mesh.vertices, mesh.triangles),
          operands({&mesh}, {winding.border()}),
          grid(winding.tree().box(), resolution),
          set(rasterise(operands, 0, grid, nullptr)) {
        sample_by_winding(set, operands, 0, grid, winding, counts, nullptr);
    }

    bool inside(int axis, std::size_t ray, int k) const {
        const LayeredDepthImage& image = set[axis];
        int index = 0;
        for (std::uint32_t i = image.begin[ray]; i < image.begin[ray + 1] && image.depth[i] <= k; ++i) {
            index += image.code[i] < 0 ? -1 : 1;
        }
        return index > 0;
    }

    /// Expects samples in their order, entries and exits in turns, normals of length 1; and nodes that are on the side
    /// that the winding number says, but for those nearer to 0.5 than its error.
    void expect_sides() const {
        std::size_t wrong = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const LayeredDepthImage& image = set[axis];
            for (std::size_t ray = 0; ray + 1 < image.begin.size(); ++ray) {
                for (std::uint32_t i = image.begin[ray]; i < image.begin[ray + 1]; ++i) {
                    ASSERT_EQ(image.code[i] >= 0, (i - image.begin[ray]) % 2 == 0);
                    EXPECT_TRUE(i == image.begin[ray] || image.depth[i - 1] <= image.depth[i]);
                    EXPECT_NEAR(image.normal[i].norm(), 1.0, 1e-5);
                }
                ASSERT_EQ((image.begin[ray + 1] - image.begin[ray]) % 2, 0U);
                for (int k = 0; k < grid.rays(); ++k) {
                    Vec3 g;
                    g[axis] = k;
                    g[(axis + 1) % 3] = static_cast<double>(ray % static_cast<std::size_t>(grid.rays()));
                    g[(axis + 2) % 3] = static_cast<double>(ray / static_cast<std::size_t>(grid.rays()));
                    const Vec3 p = grid.to_space(g);
                    const double w = winding.tree().box().contains(p) ? winding.at(p) : 0.0;
                    wrong += std::abs(w - 0.5) > 0.003 && inside(axis, ray, k) != (w >= 0.5) ? 1 : 0;
                }
            }
        }
        EXPECT_EQ(wrong, 0U);
        EXPECT_EQ(counts.nodes.left, 0U);
    }

    mesh::TriangleMesh mesh;
    mesh::SurfaceWinding winding;
    OperandSet operands;
    SampleGrid grid;
    LayeredDepthSet set;
    WindingSampleCounts counts;
};

TEST(WindingSamples, OfAClosedSurfaceAreThoseOfItsTriangles) {
    const mesh::TriangleMesh ball = solids::sphere(Vec3(0.1, 0.2, 0.3), 1.0, 24);
    const Sampled sampled(ball, 33);
    sampled.expect_sides();
    EXPECT_EQ(sampled.counts.guessed, 0U);
    EXPECT_EQ(sampled.counts.dropped, 0U);
    const LayeredDepthSet plain = rasterise(sampled.operands, 0, sampled.grid, nullptr);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(sampled.set[axis].depth, plain[axis].depth);
        EXPECT_EQ(sampled.set[axis].code, plain[axis].code);
    }
}

/// Holes from a few triangles to half of the surface are spanned.
TEST(WindingSamples, SpanHoles) {
    for (const double height : {0.97, 0.7, 0.3, 0.0}) {
        SCOPED_TRACE(height);
        const mesh::TriangleMesh bowl = solids::only(solids::sphere(Vec3(0.1, 0.2, 0.3), 1.0, 24),
                                                     [&](const Vec3& p) { return p.z() - 0.3 < height; });
        const Sampled sampled(bowl, 33);
        sampled.expect_sides();
        EXPECT_GT(sampled.counts.guessed, 10U);
        EXPECT_GT(sampled.counts.kept, 1000U);
    }
}

TEST(WindingSamples, SpanManySmallHoles) {
    std::mt19937 random(3);
    const mesh::TriangleMesh sieve =
        solids::only(solids::sphere(Vec3(0.1, 0.2, 0.3), 1.0, 40, 0.1), [&](const Vec3&) { return random() % 8 != 0; });
    const Sampled sampled(sieve, 33);
    sampled.expect_sides();
}

/// A patch that is the other way round: the number tells what its triangles say, which is not what a user meant;
/// prepare_open_operand turns it before.
TEST(WindingSamples, OfAReversedPatchFollowTheNumber) {
    mesh::TriangleMesh ball = solids::sphere(Vec3(0.1, 0.2, 0.3), 1.0, 24);
    for (mesh::Triangle& t : ball.triangles) {
        if (ball.vertices[static_cast<std::size_t>(t[0])].z() > 1.1) {
            std::swap(t[1], t[2]);
        }
    }
    Sampled(ball, 33).expect_sides();
}

/// Two spheres that overlap, each without a cap, and a sheet within: the inner surfaces go.
TEST(WindingSamples, DropWhatLiesWithin) {
    const mesh::TriangleMesh left =
        solids::only(solids::sphere(Vec3(0, 0, 0), 1.0, 24), [](const Vec3& p) { return p.x() > -0.8; });
    const mesh::TriangleMesh right =
        solids::only(solids::sphere(Vec3(0.8, 0.1, 0), 1.0, 24), [](const Vec3& p) { return p.x() < 1.5; });
    const Sampled sampled(solids::together(left, right), 33);
    sampled.expect_sides();
    EXPECT_GT(sampled.counts.dropped, 250U);
    EXPECT_GT(sampled.counts.guessed, 100U);
}

TEST(WindingSamples, CanBeCancelled) {
    const mesh::TriangleMesh bowl =
        solids::only(solids::sphere(Vec3(0, 0, 0), 1.0, 24), [](const Vec3& p) { return p.z() < 0.0; });
    Sampled sampled(bowl, 33);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(
        sample_by_winding(sampled.set, sampled.operands, 0, sampled.grid, sampled.winding, sampled.counts, &progress),
        Cancelled);
}

}  // namespace
}  // namespace mq::layered_depth

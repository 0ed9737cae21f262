// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/octree.h"

#include <gtest/gtest.h>

#include "base/parallel.h"
#include "boolean/closed_solids.h"
#include "layered_depth/samples/sample_clustering.h"

namespace mq::layered_depth {

namespace solids = boolean::solids;
namespace {

/// What an octree is made of.
struct Input {
    mesh::TriangleMesh ball = solids::sphere(Vec3(0.1, 0.2, 0.3), 1.0, 40);
    mesh::TriangleMesh block = solids::box(Vec3(0.2, -0.4, -0.3), Vec3(1.9, 0.8, 1.7));
    OperandSet pair{ball, block};
    SampleGrid grid;
    CombinedSet combined;
    std::vector<Retention> fate;
    RetainedSurface retained;

    Input() : grid(box(), 65) {
        CombineOptions options;
        options.expression = boolean::Expression::chain(boolean::Operation::Difference, 2);
        SampleCounts counts(pair.triangles.size());
        combined = combine_meshes(pair, grid, options, counts, nullptr);
        const std::vector<std::uint32_t> samples(counts.begin(), counts.end());
        fate = classify(pair, samples, cluster(pair, samples, triangles_beyond(pair, grid)), combined);
        retained = retained_surface(pair, fate);
    }
    Box box() const {
        Box box;
        for (const Vec3& p : ball.vertices) {
            box.add(p);
        }
        return box;
    }
    Octree build(std::size_t most_at_a_time) const {
        return build_octree(pair, grid, combined, fate, retained, nullptr, most_at_a_time);
    }
};

TEST(Octree, LeavesFitTheirSamples) {
    const Input input;
    const Octree tree = input.build(1U << 24);
    std::size_t found = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const CombinedDepth& direction = input.combined[axis];
        for (std::size_t ray = 0; ray + 1 < direction.begin.size(); ++ray) {
            for (std::uint32_t i = direction.begin[ray]; i < direction.begin[ray + 1]; ++i) {
                if (input.fate[CombinedDepth::triangle(direction.source[i])] != Retention::Removed) {
                    continue;
                }
                std::array<int, 3> at{};
                at[axis] = static_cast<int>(std::ceil(direction.depth[i])) - 1;
                at[(axis + 1) % 3] = static_cast<int>(ray) % input.grid.rays();
                at[(axis + 2) % 3] = static_cast<int>(ray) / input.grid.rays();
                const std::int32_t leaf = tree.leaf_at(at[0], at[1], at[2]);
                ASSERT_GE(leaf, 0) << "an IR-sample lies in no leaf";
                for (int k = 0; k < 3; ++k) {
                    EXPECT_LE(tree.leaves[leaf].low[k], at[k]);
                    EXPECT_LT(at[k], tree.leaves[leaf].low[k] + tree.leaves[leaf].size);
                }
                ++found;
            }
        }
    }
    EXPECT_GT(found, 1000U);
}

TEST(Octree, TheSameWhetherItIsBuiltAtOnceOrInLayers) {
    const Input input;
    const Octree whole = input.build(1U << 24);
    for (const int threads : {1, 3}) {
        const ThreadLimit limit(threads);
        const Octree layered = input.build(0);
        ASSERT_EQ(layered.leaves.size(), whole.leaves.size());
        ASSERT_EQ(layered.sheets.size(), whole.sheets.size());
        ASSERT_EQ(layered.edges.size(), whole.edges.size());
        for (std::size_t k = 0; k < whole.leaves.size(); ++k) {
            EXPECT_EQ(layered.leaves[k].low, whole.leaves[k].low);
            EXPECT_EQ(layered.leaves[k].size, whole.leaves[k].size);
            EXPECT_EQ(layered.leaves[k].kind, whole.leaves[k].kind);
            EXPECT_EQ(layered.leaves[k].first_sheet, whole.leaves[k].first_sheet);
        }
        for (std::size_t k = 0; k < whole.sheets.size(); ++k) {
            EXPECT_EQ(layered.sheets[k].minimiser, whole.sheets[k].minimiser);
        }
    }
}

}  // namespace
}  // namespace mq::layered_depth

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/node_consistency.h"

#include <gtest/gtest.h>

#include "boolean/closed_solids.h"
#include "layered_depth/samples/rasterise.h"

namespace mq::layered_depth {

namespace solids = boolean::solids;
namespace {

LayeredDepthImage one_ray(const std::vector<std::pair<double, std::int32_t>>& samples) {
    LayeredDepthImage image;
    image.begin = {0, static_cast<std::uint32_t>(samples.size())};
    for (const auto& [depth, code] : samples) {
        image.depth.push_back(depth);
        image.code.push_back(code);
        image.normal.emplace_back(SampleNormal::UnitX());
    }
    return image;
}

TEST(RestoreOrder, AWedgeThatTheRayMissesVanishes) {
    LayeredDepthImage image = one_ray({{1.0, 0}, {5.0, ~1}, {7.2, 2}, {7.1, ~3}, {8.0, 4}, {9.0, ~5}});
    EXPECT_EQ(restore_order(image), 2U);
    EXPECT_EQ(image.code, (std::vector<std::int32_t>{0, ~1, 4, ~5}));
    EXPECT_EQ(image.begin.back(), 4U);
    EXPECT_EQ(image.normal.size(), 4U);
}

TEST(RestoreOrder, SurfacesThatOverlapAreSorted) {
    LayeredDepthImage image = one_ray({{2.0, 0}, {1.5, 1}, {5.0, ~2}, {4.0, ~3}});
    EXPECT_EQ(restore_order(image), 0U);
    EXPECT_EQ(image.depth, (std::vector<double>{1.5, 2.0, 4.0, 5.0}));
    EXPECT_EQ(image.code, (std::vector<std::int32_t>{1, 0, ~3, ~2}));
}

class Ball : public testing::Test {
  protected:
    OperandSet pair{solids::sphere(Vec3(0.1, 0.2, 0.3), 1.0, 24), mesh::TriangleMesh()};
    SampleGrid grid{box(), 65};
    LayeredDepthSet set = rasterise(pair, 0, grid, nullptr);
    ConsistencyCounts counts;

    Box box() const {
        Box result;
        for (const Vec3& p : pair.points) {
            result.add(p);
        }
        return result;
    }
    void SetUp() override {
        for (LayeredDepthImage& image : set) {
            for (std::uint32_t i = 0; i < image.depth.size(); ++i) {
                image.normal.push_back(pair.unit_normal(image.triangle(i)).cast<float>());
            }
        }
    }
    /// Takes all samples of a ray out.
    static void empty(LayeredDepthImage& image, std::uint32_t ray) {
        const std::uint32_t first = image.begin[ray], count = image.begin[ray + 1] - first;
        image.depth.erase(image.depth.begin() + first, image.depth.begin() + first + count);
        image.code.erase(image.code.begin() + first, image.code.begin() + first + count);
        image.normal.erase(image.normal.begin() + first, image.normal.begin() + first + count);
        for (std::size_t k = ray + 1; k < image.begin.size(); ++k) {
            image.begin[k] -= count;
        }
    }
};

TEST_F(Ball, RaysOfAMeshAgree) {
    const LayeredDepthSet before = set;
    EXPECT_TRUE(make_consistent(set, grid, counts, nullptr).empty());
    EXPECT_EQ(counts.nodes, 0U);
    EXPECT_EQ(set[0].depth, before[0].depth);
}

/// A ray that grazes the ball and missed it, and one with a ball that is not there.
TEST_F(Ball, RaysGetWhatTheyMissedAndLoseWhatIsNotThere) {
    std::uint32_t grazes = 0, first = 0;
    do {
        first = set[0].begin[++grazes];
    } while (set[0].begin[grazes + 1] - first != 2 || set[0].depth[first + 1] - set[0].depth[first] < 6.0);
    const std::vector<double> truth{set[0].depth[first], set[0].depth[first + 1]};
    const std::size_t all = set[0].depth.size();
    empty(set[0], grazes);
    const std::vector<SampleRef> inserted = make_consistent(set, grid, counts, nullptr);
    ASSERT_EQ(inserted.size(), 2U);
    EXPECT_EQ(counts.inserted, 2U);
    EXPECT_EQ(counts.removed, 0U);
    EXPECT_EQ(counts.left, 0U);
    EXPECT_GE(counts.nodes, 6U);
    ASSERT_EQ(set[0].depth.size(), all);
    for (std::uint32_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(set[0].depth[first + k], truth[k], 0.5);
        EXPECT_EQ(set[0].code[first + k] >= 0, k == 0);
    }

    const std::uint32_t beside = 3 * grid.rays() + 3;
    ASSERT_EQ(set[1].begin[beside], set[1].begin[beside + 1]);
    LayeredDepthImage& image = set[1];
    const std::uint32_t at = image.begin[beside];
    image.depth.insert(image.depth.begin() + at, {20.3, 40.6});
    image.code.insert(image.code.begin() + at, {0, ~0});
    image.normal.insert(image.normal.begin() + at, 2, SampleNormal(0.999F, 0.04F, 0.0F));
    for (std::size_t k = beside + 1; k < image.begin.size(); ++k) {
        image.begin[k] += 2;
    }
    counts = {};
    make_consistent(set, grid, counts, nullptr);
    EXPECT_EQ(counts.removed, 2U);
    EXPECT_EQ(counts.inserted, 0U);
    EXPECT_EQ(counts.left, 0U);
    EXPECT_EQ(set[1].begin[beside], set[1].begin[beside + 1]);
}

}  // namespace
}  // namespace mq::layered_depth

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/layered_depth/samples/combine_samples.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace mq::boolean {
namespace {

using Ray = std::vector<std::pair<double, std::int32_t>>;

/// Operands that have samples on ray 0 of the x-LDI only.
std::array<LayeredDepthSet, 2> on_one_ray(const Ray& a, const Ray& b, const SampleGrid& grid) {
    std::array<LayeredDepthSet, 2> operands;
    const std::array<const Ray*, 2> rays{&a, &b};
    for (int k = 0; k < 2; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            LayeredDepthImage& direction = operands[k][axis];
            const std::size_t count = axis == 0 ? rays[k]->size() : 0;
            direction.begin.assign(static_cast<std::size_t>(grid.rays()) * grid.rays() + 1,
                                   static_cast<std::uint32_t>(count));
            direction.begin[0] = 0;
            for (std::size_t i = 0; i < count; ++i) {
                direction.depth.push_back((*rays[k])[i].first);
                direction.code.push_back((*rays[k])[i].second);
            }
        }
    }
    return operands;
}

std::string combined(Operation operation, const Ray& a, const Ray& b, bool normal_index = true) {
    const SampleGrid grid(Box(), 9);
    CombineOptions options;
    options.operation = operation;
    options.thinnest = 0.01;
    options.normal_index = normal_index;
    const CombinedDepth result = combine(OperandPair({}, {}), on_one_ray(a, b, grid), grid, options, nullptr)[0];
    std::string text;
    for (std::size_t i = 0; i < result.depth.size(); ++i) {
        text += (i == 0 ? "" : " ") + std::to_string(static_cast<int>(result.depth[i])) + ":" +
                std::to_string(CombinedDepth::triangle(result.source[i])) +
                (CombinedDepth::reversed(result.source[i]) ? "r" : "");
    }
    return text;
}

const Ray kA{{1, 0}, {5, ~1}};
const Ray kB{{3, 10}, {7, ~11}};

TEST(Combine, OverlappingSolids) {
    EXPECT_EQ(combined(Operation::Union, kA, kB), "1:0 7:11");
    EXPECT_EQ(combined(Operation::Intersection, kA, kB), "3:10 5:1");
    EXPECT_EQ(combined(Operation::Difference, kA, kB), "1:0 3:10r");
    EXPECT_EQ(combined(Operation::SymmetricDifference, kA, kB), "1:0 3:10r 5:1r 7:11");
    EXPECT_EQ(combined(Operation::Difference, kA, {}), "1:0 5:1");
    EXPECT_EQ(combined(Operation::Difference, {}, kB), "");
}

TEST(Combine, ThinGapsAndSlabsVanish) {
    EXPECT_EQ(combined(Operation::Union, kA, {{5.005, 10}, {7, ~11}}), "1:0 7:11");
    EXPECT_EQ(combined(Operation::Union, kA, {{4.995, 10}, {7, ~11}}), "1:0 7:11");
    EXPECT_EQ(combined(Operation::Union, kA, {{5.02, 10}, {7, ~11}}), "1:0 5:1 5:10 7:11");
    EXPECT_EQ(combined(Operation::Intersection, kA, {{4.995, 10}, {7, ~11}}), "");
    EXPECT_EQ(combined(Operation::SymmetricDifference, kA, {{1.005, 10}, {4, ~11}}), "4:11r 5:1");
    // An operand's own thin slab stays.
    EXPECT_EQ(combined(Operation::Union, {{1, 0}, {1.005, ~1}}, kB), "1:0 1:1 3:10 7:11");
}

/// Remark 3: whichever comes first, the lower triangle gives the sample.
TEST(Combine, ContactPrefersTheLowerTriangle) {
    EXPECT_EQ(combined(Operation::Union, kA, {{1.004, 10}, {5.003, ~11}}), "1:0 5:1");
    EXPECT_EQ(combined(Operation::Union, kA, {{0.996, 10}, {4.997, ~11}}), "0:0 5:1");
    EXPECT_EQ(combined(Operation::Difference, kA, {{4.996, 10}, {6, ~11}}), "1:0 4:1");
    EXPECT_EQ(combined(Operation::Difference, kA, kA), "");
    EXPECT_EQ(combined(Operation::Intersection, kA, kA), "1:0 5:1");
}

TEST(Combine, NormalIndexKeepsTheOuterSurface) {
    const Ray twice{{1, 0}, {2, 1}, {4, ~2}, {5, ~3}};
    EXPECT_EQ(combined(Operation::Union, twice, {}), "1:0 5:3");
    EXPECT_EQ(combined(Operation::Union, twice, {}, false), "1:0 2:1r 4:2r 5:3");
    // Inside out: no solid at all.
    EXPECT_EQ(combined(Operation::Union, {{1, ~0}, {5, 1}}, {}), "");
}

TEST(Combine, OpenOperandIsNamed) {
    try {
        combined(Operation::Union, kA, {{3, 10}});
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("operand B is not closed"), std::string::npos) << error.what();
    }
}

TEST(Combine, ANodeOnASampleLiesBehindIt) {
    CombinedDepth direction;
    direction.begin = {0, 2};
    direction.depth = {2.0, 4.5};
    direction.source = {0, 2};
    EXPECT_FALSE(direction.inside(0, 1));
    EXPECT_TRUE(direction.inside(0, 2));
    EXPECT_TRUE(direction.inside(0, 4));
    EXPECT_FALSE(direction.inside(0, 5));
}

}  // namespace
}  // namespace mq::boolean

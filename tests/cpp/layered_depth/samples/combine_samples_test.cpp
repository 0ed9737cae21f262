// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/combine_samples.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/parallel.h"
#include "boolean/closed_solids.h"
#include "layered_depth/samples/sample_clustering.h"

namespace mq::layered_depth {

namespace solids = boolean::solids;

using boolean::Expression;
using boolean::Operation;

namespace {

using Ray = std::vector<std::pair<double, std::int32_t>>;

/// Operands that have samples on ray 0 of the x-LDI only.
std::vector<LayeredDepthSet> on_one_ray(const std::vector<Ray>& rays, const SampleGrid& grid) {
    std::vector<LayeredDepthSet> operands(rays.size());
    for (std::size_t k = 0; k < rays.size(); ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            LayeredDepthImage& direction = operands[k][axis];
            const std::size_t count = axis == 0 ? rays[k].size() : 0;
            direction.begin.assign(static_cast<std::size_t>(grid.rays()) * grid.rays() + 1,
                                   static_cast<std::uint32_t>(count));
            direction.begin[0] = 0;
            for (std::size_t i = 0; i < count; ++i) {
                direction.depth.push_back(rays[k][i].first);
                direction.code.push_back(rays[k][i].second);
            }
        }
    }
    return operands;
}

std::string combined(const Expression& expression, const std::vector<Ray>& rays, bool normal_index = true) {
    const SampleGrid grid(Box(), 9);
    CombineOptions options;
    options.expression = expression;
    options.thinnest = 0.01;
    options.normal_index = normal_index;
    const mesh::TriangleMesh none;
    const OperandSet operands(std::vector<const mesh::TriangleMesh*>(rays.size(), &none));
    const CombinedDepth result = combine(operands, on_one_ray(rays, grid), grid, options, nullptr)[0];
    std::string text;
    for (std::size_t i = 0; i < result.depth.size(); ++i) {
        text += (i == 0 ? "" : " ") + std::to_string(static_cast<int>(result.depth[i])) + ":" +
                std::to_string(CombinedDepth::triangle(result.source[i])) +
                (CombinedDepth::reversed(result.source[i]) ? "r" : "");
    }
    return text;
}

std::string combined(Operation operation, const Ray& a, const Ray& b, bool normal_index = true) {
    return combined(Expression::chain(operation, 2), {a, b}, normal_index);
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

TEST(Combine, ManyOperandsInOnePass) {
    const Ray c{{4, 20}, {9, ~21}}, d{{10, 30}, {12, ~31}};
    const auto chain = [&](Operation operation) { return combined(Expression::chain(operation, 4), {kA, kB, c, d}); };
    EXPECT_EQ(chain(Operation::Union), "1:0 9:21 10:30 12:31");
    EXPECT_EQ(chain(Operation::Intersection), "");
    EXPECT_EQ(chain(Operation::Difference), "1:0 3:10r");
    EXPECT_EQ(chain(Operation::SymmetricDifference), "1:0 3:10r 4:20 5:1 7:11r 9:21 10:30 12:31");
    // (A u D) less (B n C).
    const std::int32_t unite = -1, intersect = -2, subtract = -3;
    EXPECT_EQ(combined(Expression::from({0, 3, unite, 1, 2, intersect, subtract}, 4), {kA, kB, c, d}),
              "1:0 4:20r 10:30 12:31");
    // Three that touch in a row: the slabs and gaps between neighbours vanish.
    EXPECT_EQ(combined(Expression::chain(Operation::Union, 3),
                       {{{1, 0}, {3, ~1}}, {{3.005, 10}, {5, ~11}}, {{4.995, 20}, {7, ~21}}}),
              "1:0 7:21");
    // Two tools with one face: the lower triangle cuts.
    EXPECT_EQ(combined(Expression::chain(Operation::Difference, 3), {kA, {{4, 10}, {6, ~11}}, {{3.997, 20}, {6, ~21}}}),
              "1:0 3:10r");
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

/// Bands are dropped once they are combined; how high they are changes nothing, nor does the number of threads.
TEST(Combine, MeshesInBandsOfAnyHeight) {
    const mesh::TriangleMesh ball = solids::sphere(Vec3(0.1, 0.2, 0.3), 1.0, 24, 0.2);
    const mesh::TriangleMesh block =
        solids::box(Vec3(0.2, -0.4, -3.0), Vec3(0.9, 0.8, 0.7));  // reaches out of the grid
    const mesh::TriangleMesh other = solids::sphere(Vec3(0.6, 0.2, 0.3), 0.7, 30);
    const OperandSet set({&ball, &block, &other});
    Box box;
    box.add(Vec3(-1.0, -0.9, -0.8));
    box.add(Vec3(1.3, 1.3, 1.4));
    const SampleGrid grid(box, 65);
    CombineOptions options;
    options.expression = Expression::chain(Operation::Difference, 3);
    options.thinnest = 1e-5;
    std::vector<LayeredDepthSet> images;
    for (int k = 0; k < 3; ++k) {
        images.push_back(rasterise(set, k, grid, nullptr));
    }
    const CombinedSet whole = combine(set, images, grid, options, nullptr);
    const std::vector<std::uint32_t> samples = count_samples(set, images);
    for (const int rows : {1, 7, 32, 1000}) {
        for (const int threads : {1, 2, 3}) {
            SCOPED_TRACE(std::to_string(rows) + " rows, " + std::to_string(threads) + " threads");
            const ThreadLimit limit(threads);
            SampleCounts counts(set.triangles.size());
            const CombinedSet banded = combine_meshes(set, grid, options, counts, nullptr, rows);
            EXPECT_EQ(std::vector<std::uint32_t>(counts.begin(), counts.end()), samples);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GT(banded[axis].depth.size(), 1000U);
                EXPECT_EQ(banded[axis].begin, whole[axis].begin);
                EXPECT_EQ(banded[axis].depth, whole[axis].depth);
                EXPECT_EQ(banded[axis].source, whole[axis].source);
            }
        }
    }
}

TEST(Combine, ARayThatDoesNotBalanceIsNamedInABandToo) {
    mesh::TriangleMesh open = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const mesh::TriangleMesh ball = solids::sphere(Vec3(0.5, 0.5, 0.5), 0.6, 12);
    open.triangles.pop_back();
    const OperandSet set({&ball, &open});
    Box box;
    box.add(Vec3(0, 0, 0));
    box.add(Vec3(1, 1, 1));
    SampleCounts counts(set.triangles.size());
    const auto message = [&](int rows) {
        try {
            combine_meshes(set, SampleGrid(box, 33), CombineOptions(), counts, nullptr, rows);
            return std::string();
        } catch (const InvalidInput& error) {
            return std::string(error.what());
        }
    };
    EXPECT_NE(message(4).find("operand B is not closed"), std::string::npos);
    EXPECT_EQ(message(4), message(1000));
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
}  // namespace mq::layered_depth

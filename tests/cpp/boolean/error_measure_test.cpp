// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/error_measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "boolean/boolean.h"
#include "boolean/closed_solids.h"
#include "mesh/intersection/surface_winding.h"

namespace mq::boolean {
namespace {

using mesh::TriangleMesh;

const Progress kUnwatched;

MeasuredError measure(const TriangleMesh& a, const TriangleMesh& b, Operation operation, const TriangleMesh& result) {
    const std::vector<EnclosedOperand> operands{{&a.vertices, &a.triangles}, {&b.vertices, &b.triangles}};
    return measure_error(operands, Expression::chain(operation, 2), result, {}, {0.02, 1e-6, 1e-6}, kUnwatched);
}

/// A triangle as small as rounding, as a result whose distance is that of a point.
TriangleMesh speck(const Vec3& p) {
    TriangleMesh mesh;
    mesh.vertices = {p, p + Vec3(1e-9, 0, 0), p + Vec3(0, 1e-9, 0)};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

const TriangleMesh kLow = solids::box(Vec3(-2, -2, -2), Vec3(2, 2, 0));   // below z = 0
const TriangleMesh kLeft = solids::box(Vec3(-2, -2, -2), Vec3(0, 2, 2));  // left of x = 0

TEST(ErrorMeasure, OfTheExactResultIsNothing) {
    for (const Operation operation : {Operation::Union, Operation::Intersection, Operation::Difference}) {
        const TriangleMesh box = solids::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
        const TriangleMesh ball = solids::sphere(Vec3(0.8, 0.7, 0.6), 1.0, 24);
        const TriangleMesh exact = boolean({&box, &ball}, operation, {}).mesh;
        EXPECT_LT(measure(box, ball, operation, exact).largest(), 1e-5) << name(operation);
    }
}

TEST(ErrorMeasure, OfADisplacedResultIsTheDisplacement) {
    TriangleMesh moved = boolean({&kLow, &kLeft}, Operation::Union, {}).mesh;
    for (Vec3& p : moved.vertices) {
        p += Vec3(0, 0, 0.1);
    }
    const MeasuredError error = measure(kLow, kLeft, Operation::Union, moved);
    EXPECT_NEAR(error.to_exact, 0.1, 0.002);
    EXPECT_NEAR(error.from_exact, 0.1, 0.002);
}

/// Near a reentrant edge of a union the nearest point of the surface is on the curve in which the operands meet, beyond
/// their triangles; near its outer edges, and within one operand, it is on a face.
TEST(ErrorMeasure, OfPointsNearEdgesIsTheirDistance) {
    const auto to_union = [](const Vec3& p) { return measure(kLow, kLeft, Operation::Union, speck(p)).to_exact; };
    EXPECT_NEAR(to_union(Vec3(-0.03, 0.1, -0.04)), 0.05, 0.001);
    EXPECT_NEAR(to_union(Vec3(0.03, 0.1, 0.04)), 0.03, 0.001);
    EXPECT_NEAR(to_union(Vec3(1.0, 0.1, -0.2)), 0.2, 0.003);
    EXPECT_NEAR(to_union(Vec3(0.0, 0.1, 0.0)), 0.0, 1e-5);
    EXPECT_NEAR(to_union(Vec3(2.3, 0.1, 0.4)), 0.5, 0.006);
    const auto to_common = [](const Vec3& p) {
        return measure(kLow, kLeft, Operation::Intersection, speck(p)).to_exact;
    };
    EXPECT_NEAR(to_common(Vec3(0.03, 0.1, 0.04)), 0.05, 0.001);
    EXPECT_NEAR(to_common(Vec3(-0.03, 0.1, -0.04)), 0.03, 0.001);
}

/// Triangles within the material are as far from the exact surface as they are deep, and what is missing is found.
TEST(ErrorMeasure, FindsSheetsThatShouldNotBeAndBodiesThatAreMissing) {
    const TriangleMesh far = solids::box(Vec3(5, 0, 0), Vec3(6, 1, 1));
    TriangleMesh sheet = solids::together(kLow, speck(Vec3::Zero()));
    sheet.triangles.back() = {static_cast<std::int32_t>(kLow.vertices.size()), 0, 3};
    sheet.vertices[kLow.vertices.size()] = Vec3(2, -2, -1);  // across the block of 4 x 4 x 2
    const MeasuredError error = measure(kLow, far, Operation::Union, sheet);
    EXPECT_GT(error.to_exact, 0.4);
    EXPECT_LE(error.to_exact, 1.02);
    EXPECT_NEAR(error.from_exact, std::sqrt(4.0 * 4.0 + 1.0), 0.1);
    const TriangleMesh none;
    EXPECT_GT(measure(kLow, far, Operation::Union, none).from_exact, 4.0);
    EXPECT_EQ(measure(kLow, far, Operation::Intersection, none).largest(), 0.0);
}

/// A corner of a large block is moved, and another body is near the opposite corner of the same triangles: only what is
/// near that is sampled, and the rest of the triangles counts by how far it is from where it was.
TEST(ErrorMeasure, CountsMovesWhereNoOtherOperandIsNear) {
    const TriangleMesh other = solids::box(Vec3(-1.9, -1.9, 0.05), Vec3(-1.5, -1.5, 0.5));
    TriangleMesh moved_block = kLow;
    for (Vec3& p : moved_block.vertices) {
        p.z() += p == Vec3(2, 2, 0) ? 0.1 : 0.0;
    }
    const TriangleMesh result = solids::together(moved_block, other);
    MovedOperands moved;
    moved.reach = 0.2;
    for (std::size_t t = 0; t < result.triangles.size(); ++t) {
        const mesh::Triangle& c = result.triangles[t];
        moved.triangles.push_back({result.vertices[static_cast<std::size_t>(c[0])],
                                   result.vertices[static_cast<std::size_t>(c[1])],
                                   result.vertices[static_cast<std::size_t>(c[2])]});
        moved.source.push_back(static_cast<std::int32_t>(t));
    }
    const std::vector<EnclosedOperand> operands{{&kLow.vertices, &kLow.triangles}, {&other.vertices, &other.triangles}};
    const MeasuredError error = measure_error(operands, Expression::chain(Operation::Union, 2), result, {},
                                              {0.05, 1e-3, 1e-6}, kUnwatched, &moved);
    EXPECT_NEAR(error.to_exact, 0.1, 0.005);
    EXPECT_NEAR(error.from_exact, 0.1, 0.005);
}

TEST(ErrorMeasure, OpenOperandsAreWhereTheirWindingNumberSaysSo) {
    const TriangleMesh open =
        solids::only(solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), [](const Vec3& centre) { return centre.z() < 0.99; });
    const mesh::SurfaceWinding winding(open.vertices, open.triangles);
    const std::vector<EnclosedOperand> operands{{&open.vertices, &open.triangles, &winding}};
    const auto distance = [&](const Vec3& p) {
        return measure_error(operands, Expression::chain(Operation::Union, 1), speck(p), {}, {0.02, 1e-6, 1e-6},
                             kUnwatched)
            .to_exact;
    };
    EXPECT_NEAR(distance(Vec3(0.5, 0.5, 0.1)), 0.1, 0.002);
    double low = 0.1;
    double high = 1.2;
    while (high - low > 1e-6) {
        const double middle = 0.5 * (low + high);
        (winding.at(Vec3(0.5, 0.5, middle)) >= 0.5 ? low : high) = middle;
    }
    EXPECT_LT(distance(Vec3(0.5, 0.5, std::min(low, 1.0) - 0.05)), 0.055);
}

}  // namespace
}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/simplex_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "base/error.h"

namespace mq::inspection {
namespace {

const std::vector<Vec3> kCube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<SimplexField::Simplex> kTetrahedra{
    {0, 1, 3, 4}, {1, 2, 3, 6}, {1, 3, 4, 6}, {1, 4, 5, 6}, {3, 4, 6, 7}};

std::vector<double> values_of(const std::vector<Vec3>& nodes) {
    std::vector<double> values;
    for (const Vec3& p : nodes) {
        values.push_back(2.0 + p.x() + 0.5 * p.y() - 0.25 * p.z());
    }
    return values;
}

TEST(SimplexField, IsLinearInTetrahedraAndThatOfTheNearestPointBeyond) {
    const SimplexField field(kCube, kTetrahedra, values_of(kCube));
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(-1.0, 2.0);
    for (int i = 0; i < 500; ++i) {
        const Vec3 p(place(random), place(random), place(random));
        const Vec3 nearest = p.cwiseMax(0.0).cwiseMin(1.0);
        EXPECT_NEAR(field.at(p), 2.0 + nearest.x() + 0.5 * nearest.y() - 0.25 * nearest.z(), 1e-12);
        EXPECT_NEAR(field.distance(p), (p - nearest).norm(), 1e-12);
    }
}

TEST(SimplexField, IsLinearOnTriangles) {
    const SimplexField field(kCube, {{0, 1, 2, -1}, {0, 2, 3, -1}}, values_of(kCube));
    EXPECT_NEAR(field.at(Vec3(0.25, 0.5, 0.7)), 2.5, 1e-12);
    EXPECT_NEAR(field.distance(Vec3(0.25, 0.5, 0.7)), 0.7, 1e-12);
    EXPECT_NEAR(field.distance(Vec3(2.0, 0.5, 0.0)), 1.0, 1e-12);
}

TEST(SimplexField, HasTheValuesAtPointsAndBetweenThemNoOthersThanTheirs) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    std::vector<Vec3> nodes;
    std::vector<SimplexField::Simplex> points;
    for (int i = 0; i < 200; ++i) {
        nodes.emplace_back(place(random), place(random), place(random));
        points.push_back({i, -1, -1, -1});
    }
    const std::vector<double> values = values_of(nodes);
    const SimplexField field(nodes, points, values);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        EXPECT_DOUBLE_EQ(field.at(nodes[i]), values[i]);
    }
    for (int i = 0; i < 200; ++i) {
        const Vec3 p(place(random), place(random), place(random));
        EXPECT_NEAR(field.at(p), 2.0 + p.x() + 0.5 * p.y() - 0.25 * p.z(), 0.35);
    }
    EXPECT_DOUBLE_EQ(SimplexField({Vec3(1, 2, 3)}, {{0, -1, -1, -1}}, {4.0}).at(Vec3(9, 9, 9)), 4.0);
}

TEST(SimplexField, TakesDegenerateSimplices) {
    const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const SimplexField field(line, {{0, 1, 2, 3}, {0, 1, 2, -1}}, {1.0, 2.0, 3.0, 4.0});
    EXPECT_NEAR(field.at(Vec3(1.5, 1.0, 0.0)), 2.5, 1e-9);
}

TEST(SimplexField, RefusesCornersThatAreNoNodes) {
    EXPECT_THROW(SimplexField(kCube, {{0, 1, 2, 8}}, values_of(kCube)), InvalidInput);
}

}  // namespace
}  // namespace mq::inspection

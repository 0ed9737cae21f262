// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/spacing_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "triangulate/random_points.h"

namespace mq::triangulate {
namespace {

TEST(CurvatureRadius, IsTheChordAsFarFromItsCircleAsAsked) {
    for (const double radius : {0.5, 3.0, 200.0}) {
        for (const double chord : {1e-4, 1e-2, 0.05}) {
            const double spacing = spacing_for(1.0 / radius, {chord, 1e-9, 1e9});
            const double sagitta = radius - std::sqrt(radius * radius - 0.25 * spacing * spacing);
            EXPECT_LE(sagitta, chord * (1.0 + 1e-9));
            if (spacing < 0.69 * radius) {
                EXPECT_NEAR(sagitta, chord, 1e-6 * chord);
            }
            EXPECT_DOUBLE_EQ(spacing_for(-1.0 / radius, {chord, 1e-9, 1e9}), spacing);
        }
    }
}

TEST(CurvatureRadius, KeepsItsBounds) {
    EXPECT_EQ(spacing_for(0.0, {0.1, 1.0, 5.0}), 5.0);
    EXPECT_EQ(spacing_for(1e9, {0.1, 1.0, 5.0}), 1.0);
    EXPECT_EQ(spacing_for(1e-9, {0.0, 1.0, 5.0}), 5.0);
    EXPECT_NEAR(spacing_for(0.5, {0.0, 1e-3, 5.0}), 1.4, 1e-12);  // 0.7 radii, mm
}

TEST(SpacingField, IsTheLeastOfAllCones) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> exponent(-3.0, 1.0);
    const std::vector<Vec3> points = random_points(500, 1);
    SpacingField field;
    std::vector<double> spacings;
    for (const Vec3& p : points) {
        spacings.push_back(std::pow(10.0, exponent(random)));
        field.add(p, spacings.back());
    }
    field.build();
    for (const Vec3& p : random_points(300, 2)) {
        double least = 2.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            least = std::min(least, spacings[i] + SpacingField::kGrowth * (points[i] - p).norm());
        }
        EXPECT_DOUBLE_EQ(field.at(p, 2.0), least);
    }
}

TEST(SpacingField, WithoutPointsIsWhatIsAskedFor) {
    SpacingField field;
    field.build();
    EXPECT_EQ(field.at(Vec3::Zero(), 7.0), 7.0);
}

}  // namespace
}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/hulls_apart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mq::curve {
namespace {

Vec3 random_vector(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double x = normal(random);
    const double y = normal(random);
    return {x, y, normal(random)};
}

TEST(Separation, HullsOnTwoSidesOfAPlaneAreApartDownToTheMargin) {
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        const Vec3 normal = random_vector(random).normalized();
        const double gap = std::pow(10.0, -static_cast<double>(round % 8));
        std::vector<Vec3> a;
        std::vector<Vec3> b;
        for (int i = 0; i < 15; ++i) {
            Vec3 p = random_vector(random);
            a.push_back(p + (gap + std::abs(p.dot(normal)) - p.dot(normal)) * normal);
            p = random_vector(random);
            b.push_back(p - (std::abs(p.dot(normal)) + p.dot(normal)) * normal);
        }
        EXPECT_TRUE(hulls_apart(a, b, 0.5 * gap)) << round;
        // They touch where one reaches the other's point.
        a.push_back(b.front());
        EXPECT_FALSE(hulls_apart(a, b, 0.0)) << round;
    }
}

TEST(Separation, HullsWhoseEdgesCrossAreNotApart) {
    const std::vector<Vec3> a{{-1, 0, 0}, {1, 0, 0}};
    EXPECT_FALSE(hulls_apart(a, {{0, -1, 0}, {0, 1, 0}}, 0.0));
    EXPECT_TRUE(hulls_apart(a, {{0, -1, 1e-9}, {0, 1, 1e-9}}, 1e-10));
    EXPECT_FALSE(hulls_apart(a, {{0, -1, 1e-9}, {0, 1, 1e-9}}, 1e-8));
}

TEST(Separation, VectorsOfAnOpenHalfSpaceAreFoundWhateverTheirLengths) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> exponent(-4.0, 0.0);
    for (int round = 0; round < 2000; ++round) {
        const Vec3 up = random_vector(random).normalized();
        const double slope = std::pow(10.0, -static_cast<double>(round % 6));
        std::vector<Vec3> vectors;
        for (int i = 0; i < 20; ++i) {
            const Vec3 v = random_vector(random);
            const Vec3 flat = (v - v.dot(up) * up).normalized();
            vectors.push_back(std::pow(10.0, exponent(random)) * (flat + slope * up));
        }
        EXPECT_TRUE(in_open_half_space(vectors, 1e-12)) << round;
        Vec3 sum = Vec3::Zero();
        for (const Vec3& v : vectors) {
            sum += v;
        }
        vectors.push_back(-sum);
        EXPECT_FALSE(in_open_half_space(vectors, 1e-12)) << round;
    }
}

TEST(Separation, VectorsShorterThanTheMarginSayNothing) {
    EXPECT_TRUE(in_open_half_space({{1, 0, 0}, {0, 1e-6, 0}}, 1e-7));
    EXPECT_FALSE(in_open_half_space({{1, 0, 0}, {0, 1e-6, 0}}, 1e-6));
}

TEST(Separation, AConeOfDirectionsThatIsThinIsFound) {
    // Vectors all but around in a plane, which only directions near one hold.
    for (const double degrees : {170.0, 179.0, 179.99, 179.9999}) {
        std::vector<Vec3> vectors;
        for (int i = 0; i <= 12; ++i) {
            const double angle = (i / 12.0 - 0.5) * degrees * M_PI / 180.0;
            vectors.emplace_back(std::cos(angle), std::sin(angle), 0.0);
            vectors.emplace_back(std::cos(angle), std::sin(angle), 1e-3);
            vectors.emplace_back(std::cos(angle), std::sin(angle), -1e-3);
        }
        EXPECT_TRUE(in_open_half_space(vectors, 1e-12)) << degrees;
        vectors.emplace_back(-1.0, 0.0, 0.0);
        EXPECT_FALSE(in_open_half_space(vectors, 1e-12)) << degrees;
    }
}

}  // namespace
}  // namespace mq::curve

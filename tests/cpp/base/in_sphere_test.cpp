// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/in_sphere.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/cases.h"
#include "base/exact.h"
#include "base/point_source.h"
#include "base/predicates.h"

namespace mq {
namespace {

class InSphereTest : public testing::TestWithParam<Points> {};

INSTANTIATE_TEST_SUITE_P(Points, InSphereTest, testing::ValuesIn(kAllPoints),
                         [](const auto& parameter) { return name_of(parameter.param); });

TEST_P(InSphereTest, IsExactAndAntisymmetric) {
    PointSource points(GetParam(), 12);
    for (int i = 0; i < scaled_cases(20000); ++i) {
        std::vector<Vec3> v = points.take(5);
        if (i % 4 == 0) {
            v[4] = v[0] + v[1] - v[2];  // on the sphere where these four make a rectangle
        }
        const int sign = in_sphere(v[0], v[1], v[2], v[3], v[4]);
        ASSERT_EQ(sign, exact::in_sphere(v[0], v[1], v[2], v[3], v[4])) << "case " << i;
        ASSERT_EQ(in_sphere(v[1], v[0], v[2], v[3], v[4]), -sign) << "case " << i;
        ASSERT_EQ(in_sphere(v[1], v[2], v[0], v[3], v[4]), sign) << "case " << i;
    }
}

TEST(InSphere, IsPositiveInside) {
    const std::array<Vec3, 4> v{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    ASSERT_GT(orient3d(v[0], v[1], v[2], v[3]), 0);
    EXPECT_EQ(in_sphere(v[0], v[1], v[2], v[3], Vec3(0.2, 0.2, 0.2)), 1);
    EXPECT_EQ(in_sphere(v[0], v[1], v[2], v[3], Vec3(1.0, 1.0, 1.0)), 0);
    EXPECT_EQ(in_sphere(v[0], v[1], v[2], v[3], Vec3(1.0, 1.0, std::nextafter(1.0, 2.0))), -1);
    EXPECT_EQ(in_sphere(v[0], v[1], v[2], v[3], Vec3(1.0, 1.0, std::nextafter(1.0, 0.0))), 1);
}

}  // namespace
}  // namespace mq

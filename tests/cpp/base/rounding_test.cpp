// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <vector>

#include "base/vec.h"

/// That the compiler rounds where the code says so. With its vectoriser of straight-line code on, g++ 12 leaves out the
/// way through single precision here; all that the Mesh kernel of FreeCAD stores, and all checks of it, rest on that.
namespace mq {
namespace {

__attribute__((noinline)) void round_all(std::vector<Vec3>& points) {
    for (Vec3& p : points) {
        const Vec3 exact = p;
        p = exact.cast<float>().cast<double>();
    }
}

__attribute__((noinline)) void round_three(double* p) {
    p[0] = static_cast<double>(static_cast<float>(p[0]));
    p[1] = static_cast<double>(static_cast<float>(p[1]));
    p[2] = static_cast<double>(static_cast<float>(p[2]));
}

/// In a way that no compiler can leave out.
bool is_single(double x) {
    volatile float stored = static_cast<float>(x);
    return static_cast<double>(stored) == x;
}

TEST(Rounding, ToSinglePrecisionTakesPlace) {
    std::vector<Vec3> points(5, Vec3(0.1, 0.2, 0.3));
    round_all(points);
    Vec3 three(0.1, 0.2, 0.3);
    round_three(three.data());
    points.push_back(three);
    for (const Vec3& p : points) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_TRUE(is_single(p[i])) << p[i];
        }
    }
}

}  // namespace
}  // namespace mq

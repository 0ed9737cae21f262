// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/vec.h"

/// Tests that the compiler rounds where the code says so. With its vectoriser of straight-line code on, g++ 12 omits
/// the conversion to single precision here, on which the contents of FreeCAD's Mesh kernel and all checks of it rely.
namespace mq {
namespace {

__attribute__((noinline)) void round_all(std::vector<Vec3>& points) {
    for (Vec3& p : points) {
        const Vec3 exact = p;
        p = exact.cast<float>().cast<double>();
    }
}

/// The loop in which the omission was found.
__attribute__((noinline)) double round_some(std::vector<Vec3>& points, const std::vector<char>& which) {
    double largest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (which[i] != 0) {
            const Vec3 exact = points[i];
            points[i] = to_single(exact);
            largest = std::max(largest, (points[i] - exact).norm());
        }
    }
    return largest;
}

__attribute__((noinline)) void round_three(double* p) {
    p[0] = static_cast<double>(static_cast<float>(p[0]));
    p[1] = static_cast<double>(static_cast<float>(p[1]));
    p[2] = static_cast<double>(static_cast<float>(p[2]));
}

/// Tests the rounding in a way that no compiler can omit.
bool is_stored(double x) {
    volatile float stored = static_cast<float>(x);
    return static_cast<double>(stored) == x;
}

TEST(Rounding, ToSinglePrecisionTakesPlace) {
    std::vector<Vec3> points(5, Vec3(0.1, 0.2, 0.3));
    round_all(points);
    Vec3 three(0.1, 0.2, 0.3);
    round_three(three.data());
    points.push_back(three);
    std::vector<Vec3> some(5, Vec3(0.1, 0.2, 0.3));
    EXPECT_LT(round_some(some, std::vector<char>(5, 1)), 1e-7);
    points.insert(points.end(), some.begin(), some.end());
    for (const Vec3& p : points) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_TRUE(is_stored(p[i])) << p[i];
        }
    }
}

}  // namespace
}  // namespace mq

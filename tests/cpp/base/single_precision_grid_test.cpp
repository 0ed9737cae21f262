// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/single_precision_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/cases.h"
#include "base/error.h"

namespace mq {
namespace {

Box box_of(const Vec3& low, const Vec3& high) {
    Box box;
    box.add(low);
    box.add(high);
    return box;
}

/// The power of two no less than the largest local coordinate of the box.
double size_of(const Box& box, const SinglePrecisionGrid& grid) {
    const double largest =
        std::max((box.low - grid.origin()).cwiseAbs().maxCoeff(), (box.high - grid.origin()).cwiseAbs().maxCoeff());
    return std::exp2(std::ceil(std::log2(largest)));
}

/// Points of the box, more of them near the planes through the local origin, where single precision is finest.
Vec3 random_point(const Box& box, const SinglePrecisionGrid& grid, std::mt19937_64& random) {
    std::uniform_real_distribution<double> real(0.0, 1.0);
    std::uniform_int_distribution<int> exponent(-70, 0);
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
        p[k] = box.low[k] + real(random) * (box.high[k] - box.low[k]);
        if (exponent(random) % 2 == 0) {
            p[k] = std::clamp(grid.origin()[k] + std::ldexp(p[k] - grid.origin()[k], exponent(random)), box.low[k],
                              box.high[k]);
        }
    }
    return p;
}

class SingleGridTest : public testing::TestWithParam<Box> {};

INSTANTIATE_TEST_SUITE_P(
    Boxes, SingleGridTest,
    testing::Values(box_of(Vec3(-1, -1, -1), Vec3(1, 1, 1)), box_of(Vec3(0, 0, 0), Vec3(100, 20, 30)),
                    box_of(Vec3(0.1, 0.2, 0.3), Vec3(64, 64, 64)), box_of(Vec3(-1e-9, 0, 0), Vec3(2e-9, 3e-9, 0)),
                    box_of(Vec3(1e6, -1e6, 1e6), Vec3(1e6 + 12.3, -1e6 + 3, 1e6 + 0.7)),
                    box_of(Vec3(3, -0.1, 0), Vec3(3.5, 0.1, 0.25)),
                    box_of(Vec3(1e9, 1e9, 1e9), Vec3(1e9 + 1, 1e9, 1e9)),
                    box_of(Vec3(-1e12, 5, 5), Vec3(-1e12 + 1e3, 6, 6)), box_of(Vec3(0, 0, 1e5), Vec3(9e5, 9e5, 1e6))));

TEST_P(SingleGridTest, SnapsToSinglePrecisionMultiplesOfTheQuantum) {
    const Box box = GetParam();
    const SinglePrecisionGrid grid(box);
    const double quantum = std::ldexp(size_of(box, grid), -48);
    std::mt19937_64 random(21);
    for (int i = 0; i < scaled_cases(100000); ++i) {
        const Vec3 p = random_point(box, grid, random);
        const Vec3 local = grid.snap(p);
        ASSERT_TRUE(is_single(local)) << local.transpose();
        const Vec3 quanta = local / quantum;
        ASSERT_EQ(quanta, quanta.array().round().matrix()) << local.transpose();
        ASSERT_LE(quanta.cwiseAbs().maxCoeff(), std::ldexp(1.0, 48));
        ASSERT_LE((grid.to_shape(local) - p).norm(), grid.resolution());
        for (int k = 0; k < 3; ++k) {
            ASSERT_FALSE(local[k] == 0.0 && std::signbit(local[k]));
        }
    }
}

TEST_P(SingleGridTest, SnappedPointsStayWhereTheyAre) {
    const SinglePrecisionGrid grid(GetParam());
    std::mt19937_64 random(22);
    const Vec3 size = Vec3::Constant(size_of(GetParam(), grid));
    const SinglePrecisionGrid local_grid(box_of(-size, size));
    for (int i = 0; i < scaled_cases(10000); ++i) {
        const Vec3 local = grid.snap(random_point(GetParam(), grid, random));
        ASSERT_EQ(local_grid.snap(local), local);
    }
}

TEST_P(SingleGridTest, FindsTheNearestPointOfTheGrid) {
    const Box box = GetParam();
    const SinglePrecisionGrid grid(box);
    const double quantum = std::ldexp(size_of(box, grid), -48);
    std::mt19937_64 random(23);
    for (int i = 0; i < scaled_cases(20000); ++i) {
        const Vec3 p = random_point(box, grid, random);
        const double exact = p.x() - grid.origin().x();
        const double snapped = grid.snap(p).x();
        for (const float limit : {-1e30f, 1e30f}) {
            const double next = std::nextafter(static_cast<float>(snapped), limit);
            const double neighbour =
                std::abs(next - snapped) < quantum ? snapped + std::copysign(quantum, limit) : next;
            ASSERT_LE(std::abs(snapped - exact), std::abs(neighbour - exact));
        }
    }
}

TEST_P(SingleGridTest, DifferencesAreExact) {
    const SinglePrecisionGrid grid(GetParam());
    std::mt19937_64 random(24);
    for (int i = 0; i < scaled_cases(20000); ++i) {
        const Vec3 a = grid.snap(random_point(GetParam(), grid, random));
        const Vec3 b = grid.snap(random_point(GetParam(), grid, random));
        const Vec3 difference = a - b;
        for (int k = 0; k < 3; ++k) {
            // two_sum's error term
            const double b_part = difference[k] - a[k];
            ASSERT_EQ((a[k] - (difference[k] - b_part)) + (-b[k] - b_part), 0.0);
        }
    }
}

TEST(SinglePrecisionGrid, KeepsTheFrameOfAPartNearTheOrigin) {
    EXPECT_EQ(SinglePrecisionGrid(box_of(Vec3(30, 0, 0), Vec3(40, 1, 1))).origin(), Vec3::Zero());
    EXPECT_EQ(SinglePrecisionGrid(Box()).origin(), Vec3::Zero());
    EXPECT_EQ(SinglePrecisionGrid(box_of(Vec3(1e6, 0, 0), Vec3(1e6, 0, 0))).origin(), Vec3::Zero());
}

TEST(SinglePrecisionGrid, MovesAPartFromFarAway) {
    const Box box = box_of(Vec3(1e6, -1e6, 0), Vec3(1e6 + 10, -1e6 + 10, 10));
    const SinglePrecisionGrid grid(box);
    EXPECT_TRUE(is_single(grid.origin()));
    EXPECT_LE((grid.origin() - box.center()).cwiseAbs().maxCoeff(), 2.0);
    EXPECT_EQ(grid.to_shape(grid.snap(box.low)), box.low);
    EXPECT_LT(grid.resolution(), 1e-6);
    const Vec3 inside(1e6 + 3, -1e6 + 4, 5);
    EXPECT_EQ(grid.to_shape(grid.snap(inside)), inside);
}

TEST(SinglePrecisionGrid, ResolutionIsHalfAUnitInTheLastPlace) {
    const double half_ulp = std::ldexp(1.0, -25);
    EXPECT_DOUBLE_EQ(SinglePrecisionGrid(box_of(Vec3(-1, 0, 0), Vec3(0.3, 1, 1))).resolution(),
                     std::sqrt(3.0) * half_ulp);
    EXPECT_DOUBLE_EQ(SinglePrecisionGrid(box_of(Vec3(0, 0, 0), Vec3(100, 1, 1))).resolution(),
                     std::sqrt(3.0) * 128.0 * half_ulp);
}

TEST(SinglePrecisionGrid, WorksWithoutAnyPoint) {
    const SinglePrecisionGrid grid{Box()};
    EXPECT_EQ(grid.snap(Vec3(1, -0.0, 0.5)), Vec3(1, 0, 0.5));
    const SinglePrecisionGrid at_origin(box_of(Vec3::Zero(), Vec3::Zero()));
    EXPECT_EQ(at_origin.snap(Vec3::Zero()), Vec3::Zero());
}

TEST(SinglePrecisionGrid, RefusesWhatSinglePrecisionCannotHold) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(SinglePrecisionGrid(box_of(Vec3(0, 0, 0), Vec3(1e30, 1, 1))), InvalidInput);
    EXPECT_THROW(SinglePrecisionGrid(box_of(Vec3(0, 0, 0), Vec3(infinity, 1, 1))), InvalidInput);
}

}  // namespace
}  // namespace mq

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/sizes/size_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "base/error.h"
#include "base/sizes/size_field_sampler.h"

namespace mq {
namespace {

using Function = std::function<double(const Vec3&)>;

const Box kBox{Vec3(-10.0, 0.0, 5.0), Vec3(90.0, 40.0, 25.0)};

SizeField sampled(SizeFieldSampler& sampler, const Function& f) {
    for (std::vector<Vec3> points = sampler.wanted(); !points.empty(); points = sampler.wanted()) {
        std::vector<double> sizes;
        for (const Vec3& p : points) {
            sizes.push_back(f(p));
        }
        sampler.give(sizes.data(), sizes.size());
    }
    return sampler.field();
}

std::vector<Vec3> points_in(const Box& box, int count) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit;
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const Vec3 t(unit(random), unit(random), unit(random));
        points.emplace_back(box.low + t.cwiseProduct(box.high - box.low));
    }
    return points;
}

TEST(SizeField, IsExactForALinearFunction) {
    SizeFieldSampler sampler(kBox, 0.01, 2, 100000);
    const Function f = [](const Vec3& p) { return 30.0 + 0.1 * p.x() - 0.2 * p.y() + 0.3 * p.z(); };
    const SizeField field = sampled(sampler, f);
    EXPECT_EQ(field.leaves().size(), 64u);  // none is divided beyond the least depth
    for (const Vec3& p : points_in(kBox, 500)) {
        EXPECT_NEAR(field.at(p), f(p), 1e-9);
    }
}

TEST(SizeField, KeepsTheErrorOfASmoothFunction) {
    SizeFieldSampler sampler(kBox, 0.05, 3, 1000000);
    const Function f = [](const Vec3& p) { return 0.5 + 0.2 * (p - Vec3(20.0, 10.0, 15.0)).norm(); };
    const SizeField field = sampled(sampler, f);
    for (const Vec3& p : points_in(kBox, 2000)) {
        EXPECT_NEAR(field.at(p) / f(p), 1.0, 0.1) << p.transpose();
    }
    EXPECT_LT(sampler.samples(), 60000u);
}

TEST(SizeField, IsNotAboveAJumpThatIsSmallerThanTheSize) {
    SizeFieldSampler sampler(kBox, 0.05, 4, 3000000);
    const Function f = [](const Vec3& p) { return (p - Vec3(20.0, 10.0, 15.0)).norm() < 6.0 ? 1.0 : 20.0; };
    const SizeField field = sampled(sampler, f);
    EXPECT_GT(sampler.unresolved(), 0u);
    for (const Vec3& p : points_in(kBox, 3000)) {
        const double distance = (p - Vec3(20.0, 10.0, 15.0)).norm();
        if (distance < 6.0) {
            EXPECT_DOUBLE_EQ(field.at(p), 1.0);
        } else if (distance > 7.0) {  // the leaves at the jump are half of the small size at most
            EXPECT_DOUBLE_EQ(field.at(p), 20.0);
        }
    }
}

TEST(SizeField, MarksFindWhatTheLeastDepthMisses) {
    const Vec3 spot(33.3, 11.1, 7.7);
    const Function f = [&](const Vec3& p) { return (p - spot).norm() < 0.4 ? 0.1 : 20.0; };
    SizeFieldSampler sampler(kBox, 0.05, 2, 1000000);
    EXPECT_DOUBLE_EQ(sampled(sampler, f).at(spot), 20.0);
    sampler.mark(spot, 0.2);
    sampler.restart();
    EXPECT_DOUBLE_EQ(sampled(sampler, f).at(spot), 0.1);
}

TEST(SizeField, EndsAtTheLimitOnSamplesWithTheLeastLengths) {
    SizeFieldSampler sampler(kBox, 0.05, 2, 20000);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> noise(0.01, 1.0);
    const SizeField field = sampled(sampler, [&](const Vec3&) { return noise(random); });
    EXPECT_LT(sampler.samples(), 60000u);
    EXPECT_GT(sampler.unresolved(), 0u);
    for (const Vec3& p : points_in(kBox, 100)) {
        EXPECT_LT(field.at(p), 0.5);
    }
}

TEST(SizeField, HasTheSizeOfTheNearestPointBeyondItsCube) {
    SizeFieldSampler sampler(kBox, 0.05, 2, 20000);
    const SizeField field = sampled(sampler, [](const Vec3& p) { return 20.0 + 0.1 * p.x(); });
    EXPECT_DOUBLE_EQ(field.at(Vec3(1e6, 10.0, 10.0)), field.at(Vec3(field.low().x() + field.side(), 10.0, 10.0)));
}

TEST(SizeField, FindsTheLeastInABox) {
    SizeFieldSampler sampler(kBox, 0.05, 3, 100000);
    const SizeField field = sampled(sampler, [](const Vec3& p) { return 20.0 + 0.1 * p.x(); });
    EXPECT_LT(field.least_in(kBox), 19.5);
    EXPECT_GT(field.least_in({Vec3(80.0, 0.0, 0.0), Vec3(81.0, 1.0, 1.0)}), 25.0);
}

TEST(SizeField, RefusesCellsThatAreNoOctree) {
    const SizeField::Corners ones{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    EXPECT_NO_THROW(SizeField(Vec3::Zero(), 1.0, {-1}, {ones}));
    EXPECT_THROW(SizeField(Vec3::Zero(), 1.0, {0}, {ones}), InvalidInput);
    EXPECT_THROW(SizeField(Vec3::Zero(), 1.0, {-2}, {ones}), InvalidInput);
    EXPECT_THROW(SizeField(Vec3::Zero(), 1.0, {1, -1}, {ones}), InvalidInput);
    EXPECT_THROW(SizeField(Vec3::Zero(), 1.0, {}, {ones}), InvalidInput);
    EXPECT_THROW(SizeField(Vec3::Zero(), 0.0, {-1}, {ones}), InvalidInput);
    SizeField::Corners zero = ones;
    zero[3] = 0.0;
    EXPECT_THROW(SizeField(Vec3::Zero(), 1.0, {-1}, {zero}), InvalidInput);
}

}  // namespace
}  // namespace mq

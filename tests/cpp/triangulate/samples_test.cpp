// SPDX-License-Identifier: LGPL-2.1-or-later
#include <random>

#include "triangulate/checks.h"
#include "triangulate/corner_fan.h"
#include "triangulate/curvature_radius.h"
#include "triangulate/edge_samples.h"
#include "triangulate/sample_index.h"
#include "triangulate/warped_face.h"

/// The pieces of the sampling methods, each against a formula or brute force.
namespace mq::triangulate {
namespace {

std::vector<Vec3> random_points(int count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-10.0, 10.0);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back(place(random), place(random), place(random));
    }
    return points;
}

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
    EXPECT_NEAR(spacing_for(0.5, {0.0, 1e-3, 5.0}), 1.4, 1e-12);  // 0.7 radii
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

TEST(SampleIndex, MissesNoPoint) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> exponent(-4.0, 1.0);
    const std::vector<Vec3> points = random_points(800, 4);
    SampleIndex index;
    for (const Vec3& p : points) {
        index.add(p, std::pow(10.0, exponent(random)));
    }
    for (const Vec3& centre : random_points(50, 6)) {
        const double radius = std::pow(10.0, exponent(random));
        std::set<int> found;
        index.any_near(centre, radius, [&](int i) {
            EXPECT_TRUE(found.insert(i).second) << "visited twice";
            return false;
        });
        for (int i = 0; i < static_cast<int>(points.size()); ++i) {
            if ((points[i] - centre).norm() <= radius) {
                EXPECT_EQ(found.count(i), 1u);
            }
        }
    }
}

TEST(CornerFan, KnowsWhatIsFree) {
    CornerFan fan(Vec3::UnitZ());
    const auto at = [&](double degrees) {
        return fan.angle_of(Vec3(std::cos(degrees * M_PI / 180.0), std::sin(degrees * M_PI / 180.0), 0.3));
    };
    EXPECT_TRUE(fan.free(at(10), at(80)));
    EXPECT_FALSE(fan.free(at(80), at(10))) << "more than half a turn";
    fan.take(at(350), at(40));
    EXPECT_FALSE(fan.free(at(10), at(80)));
    EXPECT_FALSE(fan.free(at(355), at(5)));
    EXPECT_FALSE(fan.free(at(340), at(60)));
    EXPECT_TRUE(fan.free(at(40), at(80))) << "side by side";
    EXPECT_TRUE(fan.free(at(300), at(350)));
    fan.take(at(200), at(200));  // the seam of a periodic face
    EXPECT_FALSE(fan.free(at(190), at(210)));
    EXPECT_TRUE(fan.free(at(200), at(210)));
    EXPECT_TRUE(fan.free(at(190), at(200)));
}

/// Straight borders in parameters that run hundreds of times as fast at one end as at the other.
TEST(EdgeSampler, SamplesAreEqualInLengthNotInParameters) {
    const auto model = bezier_face([](int, int) { return 0.0; }, 20.0, 0.1);
    Pipeline pipeline(model);
    const SpacingBounds bounds{0.0, 0.01, 0.5};
    SpacingField field;
    EdgeSampler sampler(pipeline.session, pipeline.initial.chains, bounds, field);
    field.build();
    sampler.resample(pipeline.initial.chains);
    for (std::size_t e = 0; e < model->topology().edges.size(); ++e) {
        const geometry::EdgeChain& chain = pipeline.initial.chains.chain(static_cast<int>(e));
        ASSERT_EQ(chain.t.size(), 21u);
        double least_step = 1e300;
        double most_step = 0.0;
        for (std::size_t i = 0; i + 1 < chain.t.size(); ++i) {
            const auto& vertices = pipeline.initial.chains.vertices();
            const double length = (vertices[chain.vertices[i + 1]].point - vertices[chain.vertices[i]].point).norm();
            EXPECT_NEAR(length, 0.5, 0.01);
            least_step = std::min(least_step, chain.t[i + 1] - chain.t[i]);
            most_step = std::max(most_step, chain.t[i + 1] - chain.t[i]);
        }
        EXPECT_GT(most_step, 20.0 * least_step);
    }
}

}  // namespace
}  // namespace mq::triangulate

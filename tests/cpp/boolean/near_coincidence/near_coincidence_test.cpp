// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/near_coincidence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boolean/boolean.h"
#include "boolean/closed_solids.h"
#include "boolean/random_meshes.h"
#include "boolean/soups.h"
#include "mesh/quality/surface_verification.h"

/// Faces that lie in one plane, both solids then rotated together: they are coplanar within the rounding of single
/// precision only.
namespace mq::boolean {
namespace {

using mesh::TriangleMesh;

TriangleMesh prism(int sides, double radius, double low, double high) {
    TriangleMesh mesh;
    for (const double z : {low, high}) {
        for (int i = 0; i < sides; ++i) {
            const double angle = 2.0 * M_PI * i / sides;
            mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
    }
    for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        mesh.triangles.push_back({i, j, sides + i});
        mesh.triangles.push_back({j, sides + j, sides + i});
    }
    for (int i = 2; i < sides; ++i) {
        mesh.triangles.push_back({0, i, i - 1});
        mesh.triangles.push_back({sides, sides + i - 1, sides + i});
    }
    return mesh;
}

class Flush : public testing::TestWithParam<int> {
  protected:
    /// Runs the operation on both operands, rotated together by the parameter's rotation.
    BooleanResult run(TriangleMesh a, TriangleMesh b, Operation operation) const {
        fuzz::Random random(static_cast<std::uint64_t>(GetParam()));
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(random.real(0.0, 3.0), random.direction()).toRotationMatrix();
        const Vec3 shift = random.direction();
        fuzz::move(a, turn, 1.0, shift);
        fuzz::move(b, turn, 1.0, shift);
        BooleanResult result = boolean({&a, &b}, operation, {});
        const mesh::Verification check = mesh::verify(result.mesh.vertices, result.mesh.triangles);
        EXPECT_TRUE(check.passed()) << check.summary();
        return result;
    }

    static void expect_solid(const BooleanResult& result, double volume, int euler) {
        const TriangleMesh& mesh = result.mesh;
        EXPECT_NEAR(fuzz::signed_volume(mesh.vertices, mesh.triangles), volume, 1e-4 * volume);
        EXPECT_EQ(static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size()) / 2, euler);
    }
};
INSTANTIATE_TEST_SUITE_P(Turns, Flush, testing::Range(0, 40));

const TriangleMesh kBlock = solids::box(Vec3(-2, -2, 0), Vec3(2, 2, 1));

double prism_volume(int sides, double radius, double height) {
    return 0.5 * sides * std::sin(2.0 * M_PI / sides) * radius * radius * height;
}

TEST_P(Flush, AHoleIsOpenAtBothEnds) {
    const BooleanResult result = run(kBlock, prism(24, 1.0, 0.0, 1.0), Operation::Difference);
    expect_solid(result, 16.0 - prism_volume(24, 1.0, 1.0), 0);
}

TEST_P(Flush, APocketIsOpenAtOneEnd) {
    const BooleanResult result = run(kBlock, prism(24, 1.0, 0.5, 1.0), Operation::Difference);
    expect_solid(result, 16.0 - prism_volume(24, 1.0, 0.5), 2);
}

TEST_P(Flush, ABossHangsTogetherWithWhatItStandsOn) {
    const BooleanResult result = run(kBlock, prism(24, 1.0, 1.0, 2.0), Operation::Union);
    expect_solid(result, 16.0 + prism_volume(24, 1.0, 1.0), 2);
}

TEST_P(Flush, BoxesOfOneSectionAreStackedToOne) {
    const TriangleMesh upper = solids::box(Vec3(-2, -2, 1), Vec3(2, 2, 2));
    expect_solid(run(kBlock, upper, Operation::Union), 32.0, 2);
    EXPECT_TRUE(run(kBlock, upper, Operation::Intersection).mesh.triangles.empty());
    expect_solid(run(kBlock, upper, Operation::Difference), 16.0, 2);
}

TriangleMesh pyramid(int sides, double radius, double low, double apex, double turn) {
    TriangleMesh mesh = prism(sides, radius, low, low + 1.0);
    for (Vec3& p : mesh.vertices) {
        p = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * p;
    }
    mesh.vertices.resize(static_cast<std::size_t>(sides));
    mesh.vertices.emplace_back(0.0, 0.0, apex);
    mesh.triangles.clear();
    for (int i = 0; i < sides; ++i) {
        mesh.triangles.push_back({i, (i + 1) % sides, sides});
    }
    for (int i = 2; i < sides; ++i) {
        mesh.triangles.push_back({0, i, i - 1});
    }
    return mesh;
}

double area(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const mesh::Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
        sum += 0.5 * (mesh.vertices[static_cast<std::size_t>(t[1])] - a)
                         .cross(mesh.vertices[static_cast<std::size_t>(t[2])] - a)
                         .norm();
    }
    return sum;
}

/// A prism and a pyramid on it, whose bases are turned against each other by less than the tolerance.
class StandingPyramid : public testing::TestWithParam<int> {
  protected:
    const double turn_ = std::pow(10.0, -1.5 - 0.5 * (GetParam() % 8));
    const int sides_ = 3 + GetParam() % 23;
    TriangleMesh prism_ = prism(sides_, 8.0, 0.0, 20.0);
    TriangleMesh pyramid_ = pyramid(sides_, 8.0, 20.0, 25.0, turn_);
    const double base_ = prism_volume(sides_, 8.0, 1.0);

    BooleanResult run(Operation operation) {
        fuzz::round_to_single(prism_);
        fuzz::round_to_single(pyramid_);
        return boolean({&prism_, &pyramid_}, operation, {});
    }
};
INSTANTIATE_TEST_SUITE_P(Turns, StandingPyramid, testing::Range(0, 46));

TEST_P(StandingPyramid, IsJoinedWithoutSlits) {
    const double ledges = 2.0 * base_ * (turn_ < 0.02 ? turn_ : 0.1);
    const BooleanResult result = run(Operation::Union);
    EXPECT_NEAR(area(result.mesh), area(prism_) + area(pyramid_) - 2.0 * base_, ledges + 1e-3);
    EXPECT_NEAR(fuzz::signed_volume(result.mesh.vertices, result.mesh.triangles), base_ * (20.0 + 5.0 / 3.0), 1e-2);
}

TEST_P(StandingPyramid, HasNothingInCommonWithThePrism) {
    EXPECT_TRUE(run(Operation::Intersection).mesh.triangles.empty());
}

TEST_P(StandingPyramid, LeavesThePrismWhole) {
    const BooleanResult result = run(Operation::Difference);
    EXPECT_NEAR(area(result.mesh), area(prism_), 1e-3);
    EXPECT_NEAR(fuzz::signed_volume(result.mesh.vertices, result.mesh.triangles), 20.0 * base_, 1e-2);
}

TEST(NearCoincidence, APlateThinnerThanTheToleranceStays) {
    const TriangleMesh block = solids::box(Vec3(0, 0, 0), Vec3(100, 100, 10));
    const TriangleMesh letter = solids::box(Vec3(20, 20, 10), Vec3(60, 60, 10.2));
    BooleanOptions options;
    options.tolerance = 0.4;
    const BooleanResult raised = boolean({&block, &letter}, Operation::Union, options);
    EXPECT_NEAR(fuzz::signed_volume(raised.mesh.vertices, raised.mesh.triangles), 1e5 + 1600.0 * 0.2, 1.0);
    const TriangleMesh engraved = solids::box(Vec3(20, 20, 9.8), Vec3(60, 60, 10.0));
    const BooleanResult sunk = boolean({&block, &engraved}, Operation::Difference, options);
    EXPECT_NEAR(fuzz::signed_volume(sunk.mesh.vertices, sunk.mesh.triangles), 1e5 - 1600.0 * 0.2, 1.0);
}

TEST(NearCoincidence, SurfacesThatCrossAtASmallAngleAreLeftAlone) {
    const TriangleMesh one = solids::sphere(Vec3(0, 0, 0), 10.0, 64);
    const TriangleMesh two = solids::sphere(Vec3(0, 0, 1.0), 10.0, 60);
    const BooleanResult result = boolean({&one, &two}, Operation::Union, {});
    EXPECT_EQ(result.separated_vertices, 0u);
    EXPECT_LT(result.error_bound, 1e-5);
}

TEST(NearCoincidence, BoxesInACornerAreJoinedAcrossThreeGaps) {
    const TriangleMesh outer = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const TriangleMesh notch = solids::box(Vec3(5, 5, 5), Vec3(11, 11, 11));
    const TriangleMesh corner = boolean({&outer, &notch}, Operation::Difference, {}).mesh;
    const TriangleMesh filling = solids::box(Vec3(5.02, 5.02, 5.02), Vec3(10, 10, 10));
    BooleanOptions options;
    options.tolerance = 0.05;
    const BooleanResult result = boolean({&corner, &filling}, Operation::Union, options);
    EXPECT_NEAR(fuzz::signed_volume(result.mesh.vertices, result.mesh.triangles), 1000.0, 0.05 * 75.0);
    EXPECT_NEAR(area(result.mesh), 600.0, 1.0);
}

TEST(NearCoincidence, NeighboursThatSinglePrecisionCannotPartAreOne) {
    const TriangleMesh lower = prism(29, 10.0, 0.0, 20.0);
    TriangleMesh upper = prism(31, 10.0, 20.0, 35.0);
    const BooleanResult result = boolean({&lower, &upper}, Operation::Union, {});
    for (const mesh::Triangle& t : result.mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = result.mesh.vertices[static_cast<std::size_t>(t[k])];
            const Vec3& q = result.mesh.vertices[static_cast<std::size_t>(t[(k + 1) % 3])];
            EXPECT_GT((p - q).norm(), 1e-6);
        }
    }
}

TEST(NearCoincidence, MovesThatLeaveATriangleWithoutAreaAreUndone) {
    const Soup before = soups::soup_of(soups::overlapping_cubes());
    Soup soup = before;
    soup.moved.assign(soup.vertices.size(), 0);
    const Triangle& t = soup.triangles[0];
    const auto corner = [&](std::size_t k) -> Vec3& { return soup.vertices[static_cast<std::size_t>(t[k])]; };
    corner(0) = 0.5 * (corner(1) + corner(2));
    soup.moved[static_cast<std::size_t>(t[0])] = 1;
    undo_degenerate_moves(soup, before.vertices);
    EXPECT_EQ(soup.vertices, before.vertices);
    EXPECT_EQ(soup.moved[static_cast<std::size_t>(t[0])], 0);
}

}  // namespace
}  // namespace mq::boolean

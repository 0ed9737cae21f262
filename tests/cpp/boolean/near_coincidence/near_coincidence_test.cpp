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

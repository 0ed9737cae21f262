// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/boolean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "boolean/closed_solids.h"
#include "boolean/random_meshes.h"
#include "mesh/quality/surface_verification.h"

namespace mq::boolean {
namespace {

using mesh::TriangleMesh;
using solids::box;
using solids::sphere;

double volume(const TriangleMesh& mesh) {
    return mesh::verify(mesh.vertices, mesh.triangles).volume;
}

/// Checks everything that the header promises of a result.
void expect_sound(const BooleanResult& result, const std::vector<const TriangleMesh*>& operands) {
    const TriangleMesh& mesh = result.mesh;
    const mesh::Verification check = mesh::verify(mesh.vertices, mesh.triangles);
    EXPECT_TRUE(check.passed()) << check.summary();
    EXPECT_EQ(result.faults_left, 0u);
    ASSERT_EQ(result.triangle_source.size(), mesh.triangles.size());
    EXPECT_EQ(result.retained + result.reconstructed, mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [operand, index] = result.triangle_source[t];
        if (operand < 0) {
            continue;
        }
        const TriangleMesh& own = *operands[static_cast<std::size_t>(operand)];
        for (const std::int32_t v : mesh.triangles[t]) {
            const mesh::Triangle& c = own.triangles[static_cast<std::size_t>(index)];
            EXPECT_TRUE(std::any_of(c.begin(), c.end(),
                                    [&](std::int32_t w) {
                                        return own.vertices[static_cast<std::size_t>(w)] ==
                                               mesh.vertices[static_cast<std::size_t>(v)];
                                    }))
                << "triangle " << t << " is not the operand's";
        }
    }
}

BooleanResult run(const TriangleMesh& a, const TriangleMesh& b, Operation operation, BooleanOptions options = {}) {
    BooleanResult result = boolean({&a, &b}, operation, options);
    expect_sound(result, {&a, &b});
    return result;
}

const TriangleMesh kCube = box(Vec3(0, 0, 0), Vec3(1, 1, 1));

TEST(Boolean, BoxesThatCross) {
    const TriangleMesh b = box(Vec3(0.5, 0.25, 0.25), Vec3(1.5, 0.75, 0.75));
    EXPECT_NEAR(volume(run(kCube, b, Operation::Union).mesh), 1.125, 1e-12);
    EXPECT_NEAR(volume(run(kCube, b, Operation::Intersection).mesh), 0.125, 1e-12);
    EXPECT_NEAR(volume(run(kCube, b, Operation::Difference).mesh), 0.875, 1e-12);
    EXPECT_NEAR(volume(run(kCube, b, Operation::SymmetricDifference).mesh), 1.0, 1e-4);
}

TEST(Boolean, NothingIsChangedAwayFromTheCurve) {
    const TriangleMesh a = sphere(Vec3(0, 0, 0), 1.0, 24);
    const TriangleMesh b = sphere(Vec3(0.9, 0.2, 0.1), 0.7, 20);
    const BooleanResult result = run(a, b, Operation::Union);
    EXPECT_GT(result.retained, 8 * result.curve_edges);
    EXPECT_LT(result.error_bound, 1e-6) << "rounding only";
}

TEST(Boolean, BoxesThatShareAFace) {
    const TriangleMesh b = box(Vec3(1, 0, 0), Vec3(2, 1, 1));
    const BooleanResult result = run(kCube, b, Operation::Union);
    EXPECT_DOUBLE_EQ(volume(result.mesh), 2.0);
    EXPECT_EQ(result.mesh.triangles.size(), 20u) << "the wall between is gone";
    EXPECT_TRUE(run(kCube, b, Operation::Intersection).mesh.triangles.empty());
    EXPECT_DOUBLE_EQ(volume(run(kCube, b, Operation::Difference).mesh), 1.0);
}

TEST(Boolean, BoxesWithCoplanarSides) {
    const TriangleMesh b = box(Vec3(0.5, 0, 0.25), Vec3(1.5, 1, 0.75));
    EXPECT_NEAR(volume(run(kCube, b, Operation::Union).mesh), 1.25, 1e-12);
    const TriangleMesh through = box(Vec3(0.25, 0.25, 0), Vec3(0.75, 0.75, 1));
    EXPECT_NEAR(volume(run(kCube, through, Operation::Difference).mesh), 0.75, 1e-12);
}

TEST(Boolean, BodiesThatTouchInAnEdgeOrAVertexArePartedByLessThanTheTolerance) {
    for (const Vec3& corner : {Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
        BooleanOptions options;
        options.tolerance = 1e-3;
        const BooleanResult result = run(kCube, box(corner, corner + Vec3(1, 1, 1)), Operation::Union, options);
        EXPECT_NEAR(volume(result.mesh), 2.0, 1e-3);
        EXPECT_EQ(result.mesh.triangles.size(), 24u) << "both bodies are there";
        EXPECT_EQ(result.separated_contacts, corner.z() == 0 ? 2u : 1u);
        EXPECT_LE(result.error_bound, options.tolerance);
        EXPECT_GT(result.error_bound, 0.0);
    }
}

TEST(Boolean, SheetsOfOneOperandThatTouchArePartedFarFromAllCrossings) {
    const TriangleMesh touching = solids::together(kCube, box(Vec3(1, 1, 0), Vec3(2, 2, 1)));
    const TriangleMesh other = box(Vec3(-0.5, -0.5, -0.5), Vec3(3, 3, 0.1));
    for (const Operation operation : {Operation::Union, Operation::Difference}) {
        const BooleanResult result = run(touching, other, operation);
        expect_sound(result, {&touching, &other});
        EXPECT_GT(result.separated_contacts, 0u);
    }
}

TEST(Boolean, CavitiesThatTouchInAnEdgeOfTheMaterialBetweenThemArePartedThere) {
    // Above and below the edge the material is connected, so that its ends have one fan each.
    const TriangleMesh block = box(Vec3(0, 0, 0), Vec3(4, 4, 3));
    const TriangleMesh one = box(Vec3(1, 1, 1), Vec3(2, 2, 2));
    const TriangleMesh two = box(Vec3(2, 2, 1), Vec3(3, 3, 2));
    const std::vector<const TriangleMesh*> all{&block, &one, &two};
    const BooleanResult result = boolean(all, Operation::Difference, {});
    expect_sound(result, all);
    EXPECT_EQ(result.separated_contacts, 1u);
    EXPECT_NEAR(volume(result.mesh), 46.0, 1e-3);
}

TEST(Boolean, WithItself) {
    const TriangleMesh a = sphere(Vec3(0, 0, 0), 1.0, 16, 0.1);
    EXPECT_TRUE(run(a, a, Operation::Difference).mesh.triangles.empty());
    EXPECT_TRUE(run(a, a, Operation::SymmetricDifference).mesh.triangles.empty());
    for (const Operation operation : {Operation::Union, Operation::Intersection}) {
        const BooleanResult result = run(a, a, operation);
        EXPECT_EQ(result.retained, a.triangles.size());
        EXPECT_EQ(result.error_bound, 0.0);
    }
}

TEST(Boolean, SurfacesThatRunAlongEachOtherKeepOneOfThem) {
    const TriangleMesh a = fuzz::torus(128, 48, 0.3);
    TriangleMesh b = a;
    fuzz::move(b, Eigen::AngleAxisd(0.01, Vec3::UnitZ()).toRotationMatrix(), 1.0, Vec3::Zero());
    TriangleMesh single = a;
    fuzz::round_to_single(single);
    const BooleanResult result = run(single, b, Operation::Union);
    EXPECT_GT(result.separated_vertices, b.vertices.size() / 2);
    EXPECT_EQ(result.mesh.triangles.size(), a.triangles.size());
    EXPECT_NEAR(volume(result.mesh), volume(single), 1e-3 * volume(single));
    EXPECT_TRUE(run(single, b, Operation::Difference).mesh.triangles.empty());
}

TEST(Boolean, ASelfIntersectingOperandCountsWhereItWindsAround) {
    TriangleMesh a = kCube;
    const TriangleMesh b = box(Vec3(0.5, 0.5, 0.5), Vec3(1.5, 1.5, 1.5));
    for (const mesh::Triangle& t : b.triangles) {
        a.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    }
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    const BooleanResult result = boolean({&a}, Operation::Union, {});
    expect_sound(result, {&a});
    EXPECT_NEAR(volume(result.mesh), 1.875, 1e-12);
}

TEST(Boolean, CavitiesStay) {
    const TriangleMesh outer = sphere(Vec3(0, 0, 0), 1.0, 16);
    const TriangleMesh inner = sphere(Vec3(0, 0, 0), 0.5, 12);
    const BooleanResult shell = run(outer, inner, Operation::Difference);
    EXPECT_NEAR(volume(shell.mesh), volume(outer) - volume(inner), 1e-9);
    const BooleanResult filled = run(shell.mesh, inner, Operation::Union);
    EXPECT_NEAR(volume(filled.mesh), volume(outer), 1e-9);
}

TEST(Boolean, ManyOperandsInOnePass) {
    const TriangleMesh x = box(Vec3(-2, -0.5, -0.5), Vec3(2, 0.5, 0.5));
    const TriangleMesh y = box(Vec3(-0.5, -2, -0.5), Vec3(0.5, 2, 0.5));
    const TriangleMesh z = box(Vec3(-0.5, -0.5, -2), Vec3(0.5, 0.5, 2));
    const std::vector<const TriangleMesh*> all{&x, &y, &z};
    const BooleanResult cross = boolean(all, Operation::Union, {});
    expect_sound(cross, all);
    EXPECT_NEAR(volume(cross.mesh), 10.0, 1e-12);
    const BooleanResult core = boolean(all, Operation::Intersection, {});
    expect_sound(core, all);
    EXPECT_NEAR(volume(core.mesh), 1.0, 1e-12);
    const BooleanResult rest = boolean(all, Operation::Difference, {});
    expect_sound(rest, all);
    EXPECT_NEAR(volume(rest.mesh), 3.0, 1e-12);
}

TEST(Boolean, HolesAreRepairedAndSaidSo) {
    TriangleMesh a = sphere(Vec3(0, 0, 0), 1.0, 16);
    const double whole = volume(a);
    a.triangles.erase(a.triangles.begin() + 100);
    const TriangleMesh b = sphere(Vec3(5, 0, 0), 1.0, 8);
    const BooleanResult result = run(a, b, Operation::Union);
    EXPECT_NEAR(volume(result.mesh), whole + volume(b), 1e-6);
    EXPECT_NE(result.repaired[0].text().find("1 hole"), std::string::npos) << result.repaired[0].text();
    EXPECT_TRUE(result.repaired[1].empty());
}

TEST(Boolean, RefusesWhatItCannotWorkOn) {
    TriangleMesh sheet;
    sheet.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    sheet.triangles = {{0, 1, 2}};
    try {
        boolean({&kCube, &sheet}, Operation::Union, {});
        FAIL() << "an open sheet was accepted";
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("operand B"), std::string::npos) << error.what();
    }
    BooleanOptions options;
    options.tolerance = std::nan("");
    EXPECT_THROW(boolean({&kCube, &kCube}, Operation::Union, options), InvalidInput);
    options.tolerance = 1e-9;
    EXPECT_THROW(boolean({&kCube, &kCube}, Operation::Union, options), InvalidInput) << "below single precision";
    options.tolerance = 0.0;
    options.resolution = 0;
    EXPECT_THROW(boolean({&kCube, &kCube}, Operation::Union, options), InvalidInput);
    EXPECT_THROW(boolean({}, Operation::Union, {}), InvalidInput);
}

TEST(Boolean, CanBeCancelledAndRepeatsItself) {
    const TriangleMesh a = sphere(Vec3(0, 0, 0), 1.0, 24);
    const TriangleMesh b = sphere(Vec3(0.5, 0.3, 0.2), 1.0, 24);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(boolean({&a, &b}, Operation::Union, {}, &progress), Cancelled);
    const BooleanResult one = boolean({&a, &b}, Operation::Union, {});
    const BooleanResult two = boolean({&a, &b}, Operation::Union, {});
    EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
    EXPECT_EQ(one.mesh.vertices, two.mesh.vertices);
}

/// Random solids, placements and defects; the same for the same seed.
class BooleanFuzz : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, BooleanFuzz, testing::Range(0, 8));

void expect_sound_booleans(const fuzz::Pair& pair) {
    SCOPED_TRACE(pair.description);
    double v[3];
    for (const Operation operation : {Operation::Union, Operation::Intersection, Operation::Difference}) {
        v[static_cast<int>(operation)] = volume(run(pair.a, pair.b, operation).mesh);
    }
    if (pair.clean) {
        const double a = volume(pair.a);
        const double b = volume(pair.b);
        EXPECT_NEAR(v[0] + v[1], a + b, 1e-4 * (a + b));
        EXPECT_NEAR(v[2], a - v[1], 1e-4 * (a + b));
    }
}

TEST_P(BooleanFuzz, ResultsAreSoundAndVolumesAddUp) {
    // Pairs of operands in one test.
    constexpr int kPairs = 6;
    for (int i = 0; i < kPairs; ++i) {
        expect_sound_booleans(fuzz::random_pair(static_cast<std::uint64_t>(GetParam() * kPairs + i)));
    }
}

TEST(Boolean, SeedsThatFailedOnce) {
    for (const std::uint64_t seed : {804, 1117, 1283, 1451, 1646, 1774, 1885}) {
        expect_sound_booleans(fuzz::random_pair(seed));
    }
    for (const std::uint64_t seed : {239, 361, 783, 2172, 2325}) {
        expect_sound_booleans(fuzz::turned_pair(seed));
    }
}

TEST(Boolean, SymmetricDifferencesThatFailedOnce) {
    const auto expect_sound_difference = [](const fuzz::Pair& pair) {
        SCOPED_TRACE(pair.description);
        run(pair.a, pair.b, Operation::SymmetricDifference);
    };
    for (const std::uint64_t seed : {728, 1202, 1518, 1524, 1831, 3141, 4083, 5181, 5648}) {
        expect_sound_difference(fuzz::random_pair(seed));
    }
    for (const std::uint64_t seed : {107, 222, 239, 305, 357, 371, 390}) {
        expect_sound_difference(fuzz::turned_pair(seed));
    }
}

/// (a - b) | (a & b) is a, whatever lies where b's surface was.
TEST(BooleanOfAnExpression, IsRoundedOnce) {
    const TriangleMesh a = kCube;
    TriangleMesh b = kCube;
    fuzz::move(b, Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix(), 1.0, Vec3(0.4, 0.3, 0.2));
    const BooleanResult result = boolean({&a, &b}, Expression::from({0, 1, -3, 0, 1, -2, -1}, 2), {});
    EXPECT_NEAR(volume(result.mesh), 1.0, 1e-6);
    EXPECT_LT(result.error_bound, 1e-6);
    EXPECT_EQ(result.faults_left, 0u);
    EXPECT_THROW(boolean({&a, &b}, Expression::chain(Operation::Union, 3), {}), InvalidInput);
}

}  // namespace
}  // namespace mq::boolean

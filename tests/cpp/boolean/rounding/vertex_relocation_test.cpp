// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/vertex_relocation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/intersection/self_intersection.h"
#include "mesh/quality/surface_verification.h"

namespace mq::boolean {
namespace {

constexpr double kUnit = 0x1p-10;

Vec3 on_grid(const Vec3& p) {
    return kUnit * (p / kUnit).array().round().matrix();
}

RelocationOptions options(double reach) {
    return {kUnit, reach, on_grid};
}

/// Appends a tetrahedron, oriented outward, with all vertices of one origin.
void add_tetrahedron(ResultMesh& draft, const std::array<Vec3, 4>& corners, char made) {
    const auto v = static_cast<std::int32_t>(draft.vertices.size());
    draft.vertices.insert(draft.vertices.end(), corners.begin(), corners.end());
    draft.made.resize(draft.vertices.size(), made);
    for (const Triangle& t : {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{1, 2, 3}, Triangle{2, 0, 3}}) {
        draft.triangles.push_back({v + t[0], v + t[1], v + t[2]});
    }
    draft.source.resize(draft.triangles.size(), Source{0, 7});
    draft.from.resize(draft.triangles.size(), 0);
    draft.displacement.resize(draft.triangles.size(), 0.0);
}

std::array<Vec3, 4> tetrahedron(const Vec3& at, double size) {
    return {at, at + Vec3(size, 0, 0), at + Vec3(0, size, 0), at + Vec3(0, 0, size)};
}

std::size_t faults_of(const ResultMesh& draft) {
    return mesh::self_intersections(draft.vertices, draft.triangles).size();
}

TEST(VertexRelocation, LeavesASoundSurfaceAlone) {
    ResultMesh draft;
    add_tetrahedron(draft, tetrahedron(Vec3::Zero(), 1.0), kConstructed);
    const std::vector<Vec3> before = draft.vertices;
    EXPECT_EQ(relocate_vertices(draft, options(8 * kUnit), Progress()).size(), 0u);
    EXPECT_EQ(draft.vertices, before);
    EXPECT_EQ(draft.source[0].triangle, 7);
}

TEST(VertexRelocation, MovesAConstructedVertexOffAFace) {
    ResultMesh draft;
    add_tetrahedron(draft, tetrahedron(Vec3::Zero(), 1.0), kFromOperand);
    // Its top passes the bottom of the first by one unit.
    add_tetrahedron(draft, {Vec3(0.25, 0.25, kUnit), Vec3(0, 0.5, -1), Vec3(0.5, 0.5, -1), Vec3(0.25, 0, -1)},
                    kConstructed);
    ASSERT_GT(faults_of(draft), 0u);
    const std::vector<Vec3> before = draft.vertices;
    EXPECT_EQ(relocate_vertices(draft, options(8 * kUnit), Progress()).size(), 0u);
    EXPECT_TRUE(mesh::verify(draft.vertices, draft.triangles).passed());
    for (std::size_t v = 0; v < before.size(); ++v) {
        EXPECT_EQ(draft.vertices[v] == before[v], v != 4) << v;
    }
    EXPECT_LE((draft.vertices[4] - before[4]).norm(), 8 * kUnit);
    EXPECT_EQ(draft.source[0].triangle, 7) << "the operand's own triangles stay its own";
    EXPECT_EQ(draft.displacement[4], (draft.vertices[4] - before[4]).norm());
    EXPECT_EQ(draft.displacement[0], 0.0);
}

TEST(VertexRelocation, MovesTheOperandsOwnWhereNothingElseHelps) {
    ResultMesh draft;
    add_tetrahedron(draft, tetrahedron(Vec3::Zero(), 1.0), kFromOperand);
    // Lifting the first corner by the reach lifts the face by less than half a unit there.
    add_tetrahedron(draft, {Vec3(0.47, 0.5, kUnit), Vec3(0, 0.5, -1), Vec3(0.5, 0.5, -1), Vec3(0.25, 0, -1)},
                    kFromOperand);
    draft.made[0] = kConstructed;
    EXPECT_EQ(relocate_vertices(draft, options(8 * kUnit), Progress()).size(), 0u);
    EXPECT_TRUE(mesh::verify(draft.vertices, draft.triangles).passed());
}

TEST(VertexRelocation, NamesWhatIsOutOfItsReach) {
    ResultMesh draft;
    add_tetrahedron(draft, tetrahedron(Vec3::Zero(), 1.0), kConstructed);
    add_tetrahedron(draft, tetrahedron(Vec3(0.1, 0.1, -0.5), 1.0), kConstructed);
    const std::size_t before = faults_of(draft);
    const EmbeddingFaults left = relocate_vertices(draft, options(8 * kUnit), Progress());
    EXPECT_GT(left.contacts.size(), 0u);
    EXPECT_LE(left.contacts.size(), before);
    EXPECT_EQ(left.contacts.size(), faults_of(draft));
}

/// Hundreds of sheets through each other: work on so many faults is not known to end well.
TEST(VertexRelocation, LeavesATangleAsItIs) {
    constexpr int kSheets = 48;
    ResultMesh draft;
    for (int i = 0; i < kSheets; ++i) {
        const double turn = M_PI * i / kSheets;
        const Vec3 out(std::cos(turn), std::sin(turn), 0.0);
        add_tetrahedron(draft, {Vec3(-out), out, Vec3(0.0, 0.0, 1.0), Vec3(1e-3 * out.y(), -1e-3 * out.x(), -1.0)},
                        kConstructed);
    }
    const std::vector<Vec3> before = draft.vertices;
    const EmbeddingFaults left =
        relocate_vertices(draft, {kUnit, 8 * kUnit, [](const Vec3& p) { return p; }}, Progress());
    EXPECT_TRUE(left.is_tangle);
    EXPECT_GT(left.size(), draft.triangles.size());
    EXPECT_EQ(draft.vertices, before);
}

TEST(VertexRelocation, SaysThatAPieceThinnerThanTheMovesMayHaveTurned) {
    ResultMesh draft;
    add_tetrahedron(draft, tetrahedron(Vec3(5, 0, 0), 1.0), kFromOperand);
    EXPECT_FALSE(relocate_vertices(draft, options(8 * kUnit), Progress()).may_have_turned);
    add_tetrahedron(draft, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.25, 0.25, 0)}, kConstructed);
    const EmbeddingFaults left = relocate_vertices(draft, options(8 * kUnit), Progress());
    EXPECT_EQ(left.size(), 0u);
    EXPECT_TRUE(left.may_have_turned);
}

/// Random tetrahedra that touch or cross by a few units: faults never become more, and no vertex leaves its reach.
TEST(VertexRelocation, NeverAddsFaults) {
    std::mt19937 dice(5);
    std::uniform_int_distribution<int> units(-3, 3);
    std::size_t all_before = 0;
    std::size_t all_after = 0;
    for (int i = 0; i < 200; ++i) {
        ResultMesh draft;
        for (int x = 0; x < 3; ++x) {
            for (int y = 0; y < 3; ++y) {
                std::array<Vec3, 4> corners = tetrahedron(Vec3(x, y, 0), 1.0);
                for (Vec3& p : corners) {
                    p += kUnit * Vec3(units(dice), units(dice), units(dice));
                }
                add_tetrahedron(draft, corners, kConstructed);
            }
        }
        const std::vector<Vec3> places = draft.vertices;
        const std::size_t before = faults_of(draft);
        const EmbeddingFaults left = relocate_vertices(draft, options(64 * kUnit), Progress());
        ASSERT_EQ(draft.triangles.size(), 36u);
        ASSERT_LE(left.size(), before) << "case " << i;
        ASSERT_EQ(left.contacts.size(), faults_of(draft)) << "case " << i;
        for (std::size_t v = 0; v < places.size(); ++v) {
            ASSERT_LE((draft.vertices[v] - places[v]).norm(), 64 * kUnit) << "case " << i;
            ASSERT_EQ(draft.vertices[v], on_grid(draft.vertices[v])) << "case " << i;
        }
        all_before += before;
        all_after += left.size();
    }
    EXPECT_GT(all_before, 400u);
    EXPECT_EQ(all_after, 0u);
}

}  // namespace
}  // namespace mq::boolean

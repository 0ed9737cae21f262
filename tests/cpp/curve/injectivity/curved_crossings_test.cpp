// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/curved_crossings.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/parallel.h"
#include "curve/checks.h"
#include "curve/injectivity/patch_mesh.h"
#include "geometry/analytic/analytic_model.h"

namespace mq::curve {
namespace {

using Corners = std::array<Vec3, 3>;
using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

const Corners kLower{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
/// It shares the edge from (1, 0, 0) to (0, 1, 0) with kLower.
const Corners kUpper{Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
const std::array<Vec3, 3> kAxes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

Pairs crossing(const CurvedCrossings& found) {
    Pairs pairs;
    for (const CurvedCrossings::Crossing& c : found.crossing) {
        pairs.emplace_back(c.a, c.b);
    }
    return pairs;
}

void expect_none(const CurvedMesh& mesh) {
    const CurvedCrossings found = curved_crossings(mesh);
    EXPECT_EQ(crossing(found), Pairs{}) << "order " << mesh.order;
    EXPECT_EQ(found.not_proven, Pairs{}) << "order " << mesh.order;
}

PatchMesh::Map lifted(double height) {
    return [height](const Vec3& p) { return Vec3(p.x(), p.y(), height + p.z() + 0.3 * p.x() * p.x()); };
}

TEST(CurvedCrossings, WallsAHundredthOfAnEdgeThickAreApart) {
    for (int order = 1; order <= 5; ++order) {
        PatchMesh mesh(order);
        for (const double height : {0.0, 0.01}) {
            mesh.add(kLower, lifted(height));
            mesh.add(kUpper, lifted(height));
        }
        expect_none(mesh.mesh);
    }
}

TEST(CurvedCrossings, APatchThroughAnotherCrossesIt) {
    for (int order = 1; order <= 5; ++order) {
        PatchMesh mesh(order);
        mesh.add(kLower, lifted(0.0));
        mesh.add({Vec3(0.3, 0.3, -1), Vec3(0.3, 0.3, 2), Vec3(2, 2, 0)});
        const CurvedCrossings found = curved_crossings(mesh.mesh);
        EXPECT_EQ(crossing(found), (Pairs{{0, 1}}));
        EXPECT_EQ(found.not_proven, Pairs{});
        ASSERT_EQ(found.crossing.size(), 1u);
        const Vec3& point = found.crossing[0].point;
        EXPECT_NEAR(point.x(), point.y(), 0.1);
        EXPECT_NEAR(point.z(), 0.3 * point.x() * point.x(), 0.1);
    }
}

TEST(CurvedCrossings, BallsCrossThoughTheirStraightTrianglesDoNot) {
    const Vec3 apart = 1.75 * Vec3(1, 1, 1).normalized();
    for (int order = 1; order <= 5; ++order) {
        PatchMesh mesh(order);
        mesh.add_ball(Vec3::Zero(), 1.0, kAxes);
        mesh.add_ball(apart, 1.0, kAxes);
        const CurvedCrossings found = curved_crossings(mesh.mesh);
        EXPECT_EQ(crossing(found), order == 1 ? Pairs{} : (Pairs{{0, 15}})) << order;
        EXPECT_EQ(found.not_proven, Pairs{}) << order;
    }
}

TEST(CurvedCrossings, ABallInABallIsApartThoughTheirStraightTrianglesCross) {
    const Vec3 out = Vec3(1, 1, 1).normalized();
    const Vec3 side = Vec3(1, -1, 0).normalized();
    for (int order = 1; order <= 5; ++order) {
        PatchMesh mesh(order);
        mesh.add_ball(Vec3::Zero(), 1.0, kAxes);
        mesh.add_ball(Vec3::Zero(), 0.8, {out, side, out.cross(side)});
        const CurvedCrossings found = curved_crossings(mesh.mesh);
        EXPECT_EQ(found.crossing.empty(), order > 1) << order;
        EXPECT_EQ(found.not_proven, Pairs{}) << order;
    }
}

TEST(CurvedCrossings, ABowlThatTouchesAPlateIsNotProvenApart) {
    PatchMesh mesh(2);
    mesh.add({Vec3(-1, -1, 0), Vec3(2, -1, 0), Vec3(-1, 2, 0)});
    mesh.add({Vec3(-0.75, -0.5, 0), Vec3(0.75, -0.5, 0), Vec3(0, 0.75, 0)},
             [](const Vec3& p) { return Vec3(p.x(), p.y(), p.x() * p.x() + p.y() * p.y()); });
    const CurvedCrossings found = curved_crossings(mesh.mesh);
    EXPECT_EQ(crossing(found), Pairs{});
    EXPECT_EQ(found.not_proven, (Pairs{{0, 1}}));
}

TEST(CurvedCrossings, NeighboursAtAnyAngleAreApart) {
    for (int order = 1; order <= 5; ++order) {
        for (const double degrees : {180.0, 120.0, 45.0, 5.0, 355.0, 359.0, 1.0}) {
            PatchMesh mesh(order);
            const double angle = degrees * M_PI / 180.0;
            const Vec3 along = Vec3(-1, 1, 0).normalized();
            const Vec3 across = Vec3(1, 1, 0).normalized();
            const Vec3 away = -std::cos(angle) * across + std::sin(angle) * Vec3::UnitZ();
            mesh.add(kLower, lifted(0.0));
            mesh.add({kLower[2], kLower[1], Vec3(0.5, 0.5, 0) + 0.1 * along + 0.8 * away}, lifted(0.0));
            expect_none(mesh.mesh);
        }
    }
}

TEST(CurvedCrossings, NeighboursFoldedBackCrossNearTheirEdge) {
    for (int order = 2; order <= 5; ++order) {
        // From the common edge y = 0 it rises, and comes back down through z = 0 at y = 1/3.
        PatchMesh mesh(order);
        mesh.add(kLower);
        mesh.add({kLower[1], kLower[0], Vec3(0.4, 0.9, 0)},
                 [](const Vec3& p) { return Vec3(p.x(), p.y(), 0.2 * p.y() - 0.6 * p.y() * p.y()); });
        const CurvedCrossings found = curved_crossings(mesh.mesh);
        EXPECT_EQ(crossing(found), (Pairs{{0, 1}})) << order;
        ASSERT_EQ(found.crossing.size(), 1u);
        EXPECT_NEAR(found.crossing[0].point.y(), 1.0 / 3.0, 0.1);
    }
}

TEST(CurvedCrossings, NeighboursAtAnAngleOfZeroAreNotProvenApart) {
    PatchMesh mesh(2);
    mesh.add(kLower);
    mesh.add({kLower[1], kLower[0], Vec3(0.5, 1, 0)},
             [](const Vec3& p) { return Vec3(p.x(), p.y(), -0.5 * p.y() * p.y()); });
    const CurvedCrossings found = curved_crossings(mesh.mesh);
    EXPECT_EQ(crossing(found), Pairs{});
    EXPECT_EQ(found.not_proven, (Pairs{{0, 1}}));
}

TEST(CurvedCrossings, NeighboursAtAVertexMayCrossElsewhere) {
    PatchMesh mesh(2);
    mesh.add(kLower);
    const auto bent = [](const Vec3& p) { return Vec3(p.x(), p.y(), 0.3 * p.x() - 0.9 * p.x() * p.x() + p.z()); };
    mesh.add({Vec3(0, 0, 0), Vec3(1, 0.4, 0), Vec3(1, 0.1, 0.3)}, bent);
    EXPECT_EQ(crossing(curved_crossings(mesh.mesh)), (Pairs{{0, 1}}));
}

TEST(CurvedCrossings, BodiesInContactDoNotCross) {
    for (int order = 1; order <= 5; ++order) {
        PatchMesh mesh(order);
        mesh.add(kLower, lifted(0.0));
        mesh.add(kUpper, lifted(0.0));
        mesh.add({kLower[0], kLower[2], kLower[1]}, lifted(0.0));
        mesh.add({kUpper[2], kUpper[1], kUpper[0]}, lifted(0.0));
        expect_none(mesh.mesh);
    }
}

TEST(CurvedCrossings, FacesThatLieOnEachOtherByOtherNodesTouchWhereTheyLookAwayFromEachOther) {
    for (int order = 1; order <= 5; ++order) {
        PatchMesh mesh(order);
        mesh.add(kLower);
        mesh.add({Vec3(0.2, 0.2, 0), Vec3(0.3, 0.9, 0), Vec3(0.8, 0.8, 0)});
        mesh.add({Vec3(0.6, 0.6, 0), Vec3(0.6, 0.9, 0), Vec3(0.9, 0.6, 0)});
        const CurvedCrossings found = curved_crossings(mesh.mesh);
        EXPECT_EQ(crossing(found), Pairs{}) << order;
        EXPECT_EQ(found.not_proven, (Pairs{{1, 2}})) << order;
        EXPECT_EQ(found.touching, (Pairs{{0, 1}})) << order;
    }
}

TEST(CurvedCrossings, TheSameEffortGivesUpPairsThatItDoesNotDecide) {
    PatchMesh mesh(2);
    // Two bowls in one another that touch along their rims only nearly: no plane has them on both sides.
    const auto bowl = [](double depth) {
        return [depth](const Vec3& p) { return Vec3(p.x(), p.y(), depth * p.x() * p.x()); };
    };
    mesh.add({Vec3(-1, -1, 0), Vec3(2, -1, 0), Vec3(-1, 2, 0)}, bowl(1.0));
    mesh.add({Vec3(-0.75, -0.5, 0), Vec3(0.75, -0.5, 0), Vec3(0, 0.75, 0)}, bowl(1.0));
    const CurvedCrossings none = curved_crossings(mesh.mesh, nullptr, {0, 0});
    EXPECT_EQ(none.not_proven, (Pairs{{0, 1}}));
    EXPECT_EQ(none.given_up, 1u);
    const CurvedCrossings all = curved_crossings(mesh.mesh);
    EXPECT_EQ(all.not_proven, (Pairs{{0, 1}}));
    EXPECT_EQ(all.given_up, 0u);
}

TEST(CurvedCrossings, ATriangleThatMeetsItselfIsNamed) {
    PatchMesh mesh(3);
    mesh.add(kLower);
    // A loop: the middle of the patch runs back over itself.
    mesh.add({Vec3(3, 0, 0), Vec3(5, 0, 0), Vec3(3, 1, 0)}, [](const Vec3& p) {
        const double t = 2.0 * (p.x() - 4.0) + 0.1;
        return Vec3(3.0 + 0.5 * (t * t * t - t), p.y(), t * t);
    });
    const CurvedCrossings found = curved_crossings(mesh.mesh);
    EXPECT_EQ(crossing(found), (Pairs{{1, 1}}));
}

TEST(CurvedCrossings, CurvedMeshesOfAnalyticModelsHaveNone) {
    for (int order = 1; order <= 5; ++order) {
        for (const auto& model : {geometry::make_sphere(1.0), geometry::make_torus(2.0, 0.6),
                                  geometry::make_cylinder(1.0, 0.02), geometry::make_cone(1.0, 2.0)}) {
            expect_none(curved(model, of_order(order)));
        }
    }
}

TEST(CurvedCrossings, DoNotDependOnTheThreadsAndMayBeCancelled) {
    PatchMesh mesh(3);
    for (int k = 0; k < 12; ++k) {
        mesh.add_ball(Vec3(0.9 * k, 0.1 * k, 0.0), 1.0, kAxes);
    }
    const auto found = [&mesh](int threads) {
        const ThreadLimit limit(threads);
        return curved_crossings(mesh.mesh);
    };
    const CurvedCrossings one = found(1);
    const CurvedCrossings four = found(4);
    EXPECT_FALSE(one.crossing.empty());
    EXPECT_EQ(crossing(one), crossing(four));
    EXPECT_EQ(one.not_proven, four.not_proven);
    EXPECT_EQ(one.compared, four.compared);
    for (std::size_t i = 0; i < one.crossing.size(); ++i) {
        EXPECT_EQ(one.crossing[i].point, four.crossing[i].point);
    }
    Progress progress;
    progress.cancel();
    EXPECT_THROW(curved_crossings(mesh.mesh, &progress), Cancelled);
}

TEST(CurvedCrossings, AnEmptyMeshHasNone) {
    expect_none(CurvedMesh{});
}

}  // namespace
}  // namespace mq::curve

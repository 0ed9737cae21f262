// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/draft.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "inspection/solids.h"

namespace mq::inspection {
namespace {

TEST(MouldDraft, OfAFrustumIsThatOfItsSides) {
    // The lower side is 20 by 20, the upper one 16 by 16, 10 higher.
    const mesh::TriangleMesh mesh =
        solids::hexahedron({Vec3(-10, -10, 0), Vec3(10, -10, 0), Vec3(-10, 10, 0), Vec3(10, 10, 0), Vec3(-8, -8, 10),
                            Vec3(8, -8, 10), Vec3(-8, 8, 10), Vec3(8, 8, 10)});
    const MouldDraft found = draft(mesh, {}, {});
    const double slope = 180.0 / M_PI * std::atan(0.2);
    for (std::size_t k = 0; k < 12; ++k) {
        EXPECT_NEAR(found.angle[k], k < 2 ? -90.0 : k < 4 ? 90.0 : slope, 1e-12);
        EXPECT_EQ(found.release[k], k < 2 ? Release::Against : Release::Along);
    }
    DraftOptions down;
    down.pull = Vec3(0, 0, -3);
    const MouldDraft turned = draft(mesh, {}, down);
    EXPECT_NEAR(turned.angle[5], -slope, 1e-12);
    EXPECT_EQ(turned.release[5], Release::Against);
}

TEST(MouldDraft, WallsAlongThePullLeaveEitherWay) {
    const MouldDraft found = draft(solids::pipe(0.0, 5.0, 10.0, 40), {}, {});
    std::size_t walls = 0;
    for (std::size_t k = 0; k < found.angle.size(); ++k) {
        if (std::abs(found.angle[k]) < 1.0) {
            EXPECT_EQ(found.release[k], Release::Both);
            ++walls;
        }
    }
    EXPECT_GT(walls, 100u);
}

TEST(MouldDraft, FindsUndercuts) {
    // A mushroom: the cap is wider than the stem, on a foot as wide.
    mesh::TriangleMesh mesh = solids::box(Vec3(-10, -10, 0), Vec3(10, 10, 2));
    solids::add(mesh, solids::box(Vec3(-3, -3, 1.5), Vec3(3, 3, 8.5)));
    solids::add(mesh, solids::box(Vec3(-10, -10, 8), Vec3(10, 10, 12)));
    const MouldDraft found = draft(mesh, {}, {});
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const mesh::Triangle& t = mesh.triangles[k];
        const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
        const bool is_between = middle.z() > 1.6 && middle.z() < 8.4 && middle.cwiseAbs().head<2>().maxCoeff() < 9.0;
        const bool faces_gap = (middle.z() == 2.0 || middle.z() == 8.0) && middle.cwiseAbs().head<2>().maxCoeff() > 3.2;
        if (is_between || faces_gap) {
            EXPECT_EQ(found.release[k], Release::Undercut) << middle.transpose();
        }
    }
    EXPECT_EQ(found.release[0], Release::Against);
    EXPECT_EQ(found.release[26], Release::Along);
}

TEST(MouldDraft, TakesTheNormalsThatAreGiven) {
    const mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const std::vector<Vec3> normals(12, Vec3(0.6, 0.0, 0.8));
    const MouldDraft found = draft(mesh, normals, {});
    EXPECT_NEAR(found.angle[7], 180.0 / M_PI * std::asin(0.8), 1e-12);
}

TEST(MouldDraft, IsTheSameForAnyNumberOfThreadsAndChecksItsInput) {
    const mesh::TriangleMesh mesh = solids::sphere(5.0, 4);
    MouldDraft before;
    for (const int threads : {1, 3}) {
        const ThreadLimit limit(threads);
        const MouldDraft found = draft(mesh, {}, {});
        if (threads > 1) {
            EXPECT_EQ(found.angle, before.angle);
            EXPECT_EQ(found.release, before.release);
        }
        before = found;
    }
    DraftOptions options;
    options.pull = Vec3::Zero();
    EXPECT_THROW(draft(mesh, {}, options), InvalidInput);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(draft(mesh, {}, {}, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::inspection

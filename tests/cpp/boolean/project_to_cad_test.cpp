// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/project_to_cad.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/error.h"
#include "boolean/boolean.h"
#include "boolean/closed_solids.h"
#include "geometry/analytic/analytic_model.h"
#include "mesh/quality/surface_verification.h"

namespace mq::boolean {
namespace {

/// A ball about the origin and a box in its first octant, as meshes and as models.
class BallAndBox : public testing::Test {
  protected:
    /// Radius of the ball and side of the box, mm.
    static constexpr double kRadius = 1.2, kSide = 2.0;

    void run(Operation operation) {
        result_ = boolean({&ball_, &box_}, operation, {});
        before_ = result_.mesh;
    }
    CadProjection fit(bool ball_is_shape, bool box_is_shape, double limit = 0.1) {
        std::vector<CadOperand> operands(2);
        operands[0] = {&ball_, ball_is_shape ? geometry::make_sphere(kRadius) : nullptr, &ball_faces_};
        operands[1] = {&box_, box_is_shape ? geometry::make_box(kSide, kSide, kSide) : nullptr, &box_faces_};
        return project_to_cad(result_.mesh, result_.triangle_source, operands, engine_, 1e-6, limit, progress_);
    }
    /// The vertices that belong only to triangles made by the Boolean.
    std::set<std::int32_t> made() const {
        std::set<std::int32_t> vertices;
        for (const bool own : {false, true}) {
            for (std::size_t t = 0; t < result_.mesh.triangles.size(); ++t) {
                if ((result_.triangle_source[t][0] >= 0) == own) {
                    for (const std::int32_t v : result_.mesh.triangles[t]) {
                        own ? void(vertices.erase(v)) : void(vertices.insert(v));
                    }
                }
            }
        }
        return vertices;
    }
    static double from_ball(const Vec3& p) { return std::abs(p.norm() - kRadius); }
    static double from_octant(const Vec3& p) { return p.cwiseAbs().minCoeff(); }
    void expect_sound() const {
        const mesh::Verification check = mesh::verify(result_.mesh.vertices, result_.mesh.triangles);
        EXPECT_TRUE(check.passed()) << check.summary();
    }

    mesh::TriangleMesh ball_ = solids::sphere(Vec3::Zero(), kRadius, 9);
    mesh::TriangleMesh box_ = solids::box(Vec3::Zero(), Vec3::Constant(kSide));
    std::vector<std::int32_t> ball_faces_ = std::vector<std::int32_t>(ball_.triangles.size(), 0);
    std::vector<std::int32_t> box_faces_{4, 4, 5, 5, 2, 2, 3, 3, 0, 0, 1, 1};
    BooleanResult result_;
    mesh::TriangleMesh before_;
    geometry::Engine engine_;
    Progress progress_;
};

TEST_F(BallAndBox, AlongTheCurveVerticesComeToLieOnBothSurfaces) {
    for (const Operation operation : {Operation::Union, Operation::Intersection, Operation::Difference}) {
        run(operation);
        const CadProjection done = fit(true, true);
        EXPECT_GE(done.moved, 20u);
        EXPECT_EQ(done.left, 0u);
        double before = 0.0, after = 0.0;
        std::size_t on_curve = 0;
        for (const std::int32_t v : made()) {
            const Vec3 p = before_.vertices[static_cast<std::size_t>(v)];
            if (from_ball(p) < 0.2 && from_octant(p) < 1e-6) {
                const Vec3 q = result_.mesh.vertices[static_cast<std::size_t>(v)];
                before = std::max(before, from_ball(p));
                after = std::max({after, from_ball(q), from_octant(q)});
                ++on_curve;
            }
        }
        EXPECT_GE(on_curve, done.moved);
        EXPECT_GT(before, 5e-3);
        EXPECT_LT(after, done.reverted == 0 ? 1e-6 : before);
        expect_sound();
    }
}

TEST_F(BallAndBox, AShapeThatMeetsAMeshIsFittedWithinTheMeshsPlane) {
    run(Operation::Difference);
    const CadProjection done = fit(true, false);
    EXPECT_GE(done.moved, 20u);
    for (std::size_t v = 0; v < before_.vertices.size(); ++v) {
        const Vec3 move = result_.mesh.vertices[v] - before_.vertices[v];
        if (move.norm() > 0.0) {
            EXPECT_LT(from_octant(result_.mesh.vertices[v]), 1e-6);
            EXPECT_LT(from_ball(result_.mesh.vertices[v]), 1e-6);
        }
    }
    expect_sound();
}

TEST_F(BallAndBox, NothingElseMovesAndNothingMovesTooFar) {
    run(Operation::Union);
    const std::set<std::int32_t> made_here = made();
    const double limit = 2e-3;
    const CadProjection done = fit(true, true, limit);
    EXPECT_GT(done.left, 0u);
    EXPECT_LE(done.largest_move, limit + 1e-6);
    for (std::size_t v = 0; v < before_.vertices.size(); ++v) {
        const Vec3& p = result_.mesh.vertices[v];
        if (made_here.count(static_cast<std::int32_t>(v)) == 0) {
            EXPECT_EQ(p, before_.vertices[v]);
        }
        EXPECT_EQ(p, to_single(p));
        EXPECT_LE((p - before_.vertices[v]).norm(), limit + 1e-6);
    }
    expect_sound();
}

TEST_F(BallAndBox, MeshesAlone) {
    run(Operation::Union);
    EXPECT_EQ(fit(false, false).moved, 0u);
    EXPECT_EQ(result_.mesh.vertices, before_.vertices);
}

TEST_F(BallAndBox, Cancel) {
    run(Operation::Union);
    progress_.cancel();
    EXPECT_THROW(fit(true, true), Cancelled);
}

}  // namespace
}  // namespace mq::boolean

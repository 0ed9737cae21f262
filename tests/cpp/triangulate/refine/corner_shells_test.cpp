// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/corner_shells.h"

#include <map>

#include "triangulate/checks.h"

/// Input angles smaller than any bound: refinement terminates, and only triangles in these corners are below the
/// bound.
namespace mq::triangulate {
namespace {

std::string text_of(const mesh::ExemptReason& why) {
    return mesh::message_of(why).text();
}

double distance_from_axis(const mesh::TriangleMesh& mesh, std::size_t t) {
    double nearest = 1e300;
    for (const Vec3& p : corners_of(mesh, t)) {
        nearest = std::min(nearest, (p + mesh.origin).head<2>().norm());
    }
    return nearest;
}

class WedgeTest : public testing::TestWithParam<double> {
  protected:
    Result mesh_wedge(double bound, Insertion insertion) const {
        TriangulateOptions options;
        options.min_angle = bound;
        options.insertion = insertion;
        const auto model = geometry::make_shape_model(geometry::wedge(GetParam(), 10.0, 3.0));
        Result result = mesh_of(model, options);
        expect_sound(result, 2, true);
        expect_angles(result, bound);
        EXPECT_TRUE(result.report.complete);
        EXPECT_EQ(result.report.exempt.empty(), GetParam() > bound);
        for (const auto& [t, why] : result.report.exempt) {
            // The room around the nodes of the tip is as large as the height of the wedge; farther triangles reach the
            // bound.
            EXPECT_LT(distance_from_axis(result.mesh, t), 3.0) << text_of(why);
        }
        return result;
    }
};

INSTANTIATE_TEST_SUITE_P(Angles, WedgeTest, testing::Values(2.0, 5.0, 15.0, 22.0));

TEST_P(WedgeTest, OnlyItsTipIsExempt) {
    for (const double bound : {20.0, 25.0, 30.0}) {
        SCOPED_TRACE(bound);
        const Result result = mesh_wedge(bound, Insertion::OffCentre);
        EXPECT_LT(result.mesh.triangles.size(), 4000u);
        for (const auto& [t, why] : result.report.exempt) {
            EXPECT_TRUE(why.cause == Cause::NarrowCorner || why.cause == Cause::NarrowCluster) << text_of(why);
        }
    }
}

/// The paper's rule can crowd vertices (its centroids lie nearer to the shortest edge than circumcentres), but only in
/// the corner.
TEST_P(WedgeTest, ThePapersRuleEndsToo) {
    for (const double bound : {20.0, 25.0, 30.0}) {
        SCOPED_TRACE(bound);
        const Result result = mesh_wedge(bound, Insertion::Circumcentre);
        EXPECT_LT(result.mesh.triangles.size(), 10000u);
        EXPECT_LT(result.report.exempt.size(), result.mesh.triangles.size() / 10 + 3);
    }
}

/// The angle in the corner is that of the shape.
TEST_P(WedgeTest, TheTipKeepsTheAngleOfThePart) {
    const Result result = mesh_of(geometry::make_shape_model(geometry::wedge(GetParam(), 10.0, 3.0)));
    EXPECT_NEAR(result.report.min_angle, std::min(GetParam(), result.report.min_angle_unexempted), 0.01);
}

TEST(Cusp, EndsWithABoundedNumberOfTriangles) {
    for (const bool thick : {false, true}) {
        const TopoDS_Shape face = geometry::cusp();
        const auto model = geometry::make_shape_model(thick ? geometry::extruded(face, 1.0) : face);
        for (const double chord : {0.0, 0.01}) {
            SCOPED_TRACE(chord);
            TriangulateOptions options;
            options.chord_height = chord;
            const Result result = mesh_of(model, options);
            expect_sound(result, thick ? 2 : 1, thick);
            expect_angles(result, 25.0);
            EXPECT_TRUE(result.report.complete);
            EXPECT_LT(result.mesh.triangles.size(), 1000u);
            // The line touches both arcs, too: three cusps, and in a plane face one triangle fills each of them.
            EXPECT_EQ(result.report.exempt.size(), thick ? 6u : 3u);
            for (const auto& [t, why] : result.report.exempt) {
                EXPECT_EQ(why.cause, Cause::NarrowCorner) << text_of(why);
            }
        }
    }
}

/// On the narrow side of a thin plate the innermost pieces of a cusp may be about as long as the plate is thick,
/// however short the edges across it are.
TEST(Cusp, OfAThinPlateHasLongPieces) {
    const std::map<double, std::size_t> most = {{0.1, 3400}, {0.2, 1800}, {0.4, 800}};  // triangles by thickness
    for (const auto& [thickness, triangles] : most) {
        SCOPED_TRACE(thickness);
        const Result result = mesh_of(geometry::make_shape_model(geometry::extruded(geometry::cusp(), thickness)));
        expect_sound(result, 2, true);
        expect_angles(result, 25.0);
        EXPECT_LT(result.mesh.triangles.size(), triangles);
        for (const auto& [t, why] : result.report.exempt) {
            EXPECT_EQ(why.cause, Cause::NarrowCorner) << text_of(why);
        }
    }
}

/// A sickle between two tangent circles, one inside the other: both of its ends are the same cusp.
TEST(Cusp, ASickleEndsToo) {
    const gp_Circ outer = geometry::circle_about(0.0, 0.0, 10.0);
    const gp_Circ inner = geometry::circle_about(4.0, 0.0, 6.0);
    const TopoDS_Shape half = geometry::planar_face(
        {geometry::arc(outer, 0.0, M_PI), geometry::line(-10.0, 0.0, -2.0, 0.0), geometry::arc(inner, 0.0, M_PI)});
    const auto model = geometry::make_shape_model(geometry::extruded(half, 2.0));
    for (const Insertion insertion : {Insertion::OffCentre, Insertion::Circumcentre}) {
        TriangulateOptions options;
        options.insertion = insertion;
        const Result result = mesh_of(model, options);
        expect_sound(result, 2, true);
        expect_angles(result, 25.0);
        EXPECT_LT(result.mesh.triangles.size(), 20000u);
    }
}

/// Arcs that curve the same way remain close over a long distance. Beside short pieces of them no good triangles fit,
/// and the gradation to these takes thousands; beside long pieces there is room.
TEST(Cusp, BetweenArcsThatTurnTheSameWayHasLongPieces) {
    for (const double ratio : {1.05, 1.1, 1.3, 1.5}) {
        for (const double turn : {29.0, 60.0}) {
            const auto model = geometry::make_shape_model(geometry::crescent(10.0, 10.0 * ratio, turn, turn / ratio));
            for (const double chord : {0.0, 0.1, 0.01}) {
                SCOPED_TRACE(testing::Message() << ratio << ", " << turn << " degrees, " << chord);
                TriangulateOptions options;
                options.chord_height = chord;
                const Result result = mesh_of(model, options);
                expect_sound(result, 1, false);
                expect_angles(result, 25.0);
                EXPECT_LT(result.mesh.triangles.size(), 2000u);
                ASSERT_EQ(result.report.exempt.size(), 1u);
                EXPECT_EQ(result.report.exempt.front().second.cause, Cause::NarrowCorner);
            }
        }
    }
}

/// The trailing edge of a blade is no corner of a face, but as thin as one.
TEST(Blade, EndsAndNamesWhatItExempts) {
    const auto model = geometry::make_shape_model(geometry::stored("blade"));
    const Result result = mesh_of(model);
    expect_sound(result, 2, true);
    expect_angles(result, 25.0);
    EXPECT_LT(result.report.exempt.size(), result.mesh.triangles.size() / 10);
}

}  // namespace
}  // namespace mq::triangulate

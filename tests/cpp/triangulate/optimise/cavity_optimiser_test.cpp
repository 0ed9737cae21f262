// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/optimise/cavity_optimiser.h"

#include <array>
#include <set>

#include "triangulate/checks.h"
#include "triangulate/ring_mesh.h"
#include "triangulate/surface_samples.h"
#include "triangulate/work_mesh/corner_classification.h"

/// Local improvement: discs of triangles that are replaced by fans.
namespace mq::triangulate {
namespace {

/// A tip of a few degrees causes a long edge next to short ones; on the faces beside it this needs a graded fan, which
/// refinement cannot make because of encroachment.
TEST(CavityOptimiser, LeavesOnlyTheCornersOfThePartBelowTheBound) {
    for (const double angle : {3.0, 5.0, 8.0, 15.0}) {
        SCOPED_TRACE(angle);
        const Result result = mesh_of(geometry::make_shape_model(geometry::wedge(angle, 10.0, 3.0)));
        expect_sound(result, 2, true);
        expect_angles(result, 25.0);
        EXPECT_EQ(result.report.exempt.size(), 2u);
        for (const auto& [t, why] : result.report.exempt) {
            EXPECT_EQ(why.cause, mesh::ExemptCause::NarrowCorner) << mesh::message_of(why).text();
        }
    }
}

void expect_cone_without_exemptions(double radius, const TriangulateOptions& options) {
    const Result result =
        mesh_of(geometry::make_shape_model(BRepPrimAPI_MakeCone(radius, 0.0, 300.0).Shape()), options);
    expect_sound(result, 2, true);
    expect_angles(result, options.min_angle);
    EXPECT_TRUE(result.report.exempt.empty());
}

/// At 30 degrees at most six triangles fill a straight angle beside such an edge, and four the apex of a cone of 44
/// degrees.
TEST(CavityOptimiser, LeavesOnlyTheCornersOfThePartBelow30Degrees) {
    TriangulateOptions options;
    options.min_angle = 30.0;
    for (const double angle : {2.0, 3.0, 5.0, 8.0, 15.0}) {
        SCOPED_TRACE(angle);
        const Result result = mesh_of(geometry::make_shape_model(geometry::wedge(angle, 10.0, 3.0)), options);
        expect_sound(result, 2, true);
        expect_angles(result, 30.0);
        EXPECT_EQ(result.report.exempt.size(), 2u);
    }
    options.chord_height_relative = 2e-3;
    for (const double radius : {95.0, 110.0, 120.0, 140.0, 200.0}) {
        SCOPED_TRACE(radius);
        expect_cone_without_exemptions(radius, options);
    }
}

/// Where four triangles meet in an apex of 96 or 99 degrees, one has to be removed.
TEST(CavityOptimiser, LeavesThreeTrianglesAtASlenderApex) {
    TriangulateOptions options;
    options.chord_height_relative = 2e-3;
    for (const double radius : {83.0, 86.0}) {
        SCOPED_TRACE(radius);
        expect_cone_without_exemptions(radius, options);
    }
}

/// Flat triangles have less angle at an apex than the cone: three of 25 degrees have no room in one of 74 to 89. This
/// is the reported cause, independent of the cause for which refinement exempted them.
TEST(CavityOptimiser, NamesTheApexWhereNotThreeTrianglesHaveRoom) {
    TriangulateOptions options;
    options.chord_height_relative = 2e-3;
    for (const double radius : {63.0, 66.0, 70.0, 74.0, 76.0}) {
        SCOPED_TRACE(radius);
        const Result result =
            mesh_of(geometry::make_shape_model(BRepPrimAPI_MakeCone(radius, 0.0, 300.0).Shape()), options);
        expect_angles(result, 25.0);
        EXPECT_FALSE(result.report.exempt.empty());
        for (const auto& [t, why] : result.report.exempt) {
            EXPECT_EQ(why.cause, mesh::ExemptCause::Apex) << mesh::message_of(why).text();
            EXPECT_EQ(why.vertex.dimension, 0);
        }
    }
}

TEST(CavityOptimiser, KeepsTheChordHeightAndTheLengthsAskedFor) {
    TriangulateOptions options;
    options.chord_height = 0.01;
    options.max_edge = 1.5;
    const auto model = geometry::make_shape_model(geometry::extruded(geometry::cusp(), 1.0));
    const Result result = mesh_of(model, options);
    expect_angles(result, 25.0);
    EXPECT_LE(result.report.max_chord_height, 0.01);
    for (const mesh::Triangle& t : result.mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_LE((result.mesh.vertices[t[i]] - result.mesh.vertices[t[(i + 1) % 3]]).norm(), 1.5 + 1e-9);
        }
    }
}

TEST(CavityOptimiser, EndsWithTheAttemptsThatItMayMake) {
    for (const std::size_t most : {0U, 1U}) {
        Pipeline pipeline(geometry::make_shape_model(geometry::wedge(5.0, 10.0, 3.0)));
        pipeline.refine(25.0);
        const Sizing none{0.0, EdgeBounds(pipeline.session.topology(), 0.0, {})};
        CavityOptimiser optimiser(pipeline.work, 25.0, none, most);
        EXPECT_EQ(optimiser.improve_once(), most > 0);
        EXPECT_FALSE(optimiser.search());
        EXPECT_EQ(optimiser.attempts_left(), 0U);
        EXPECT_FALSE(optimiser.bad_triangles().empty());
    }
}

TEST(CavityOptimiser, StopsWhenAsked) {
    Pipeline pipeline(geometry::make_shape_model(geometry::wedge(5.0, 10.0, 3.0)));
    pipeline.refine(25.0);
    pipeline.progress.cancel();
    const Sizing none{0.0, EdgeBounds(pipeline.session.topology(), 0.0, {})};
    EXPECT_THROW(mend(pipeline.work, 25.0, none), Cancelled);
}

}  // namespace
}  // namespace mq::triangulate

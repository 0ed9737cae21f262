// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <gp_GTrsf.hxx>

#include "mesh/intersection/self_intersection.h"
#include "triangulate/checks.h"

/// Wires, rods and needles: smooth surfaces that are much longer than wide, with no small angle except at the apex of
/// a needle.
namespace mq::triangulate {
namespace {

TriangulateOptions with(Insertion insertion) {
    TriangulateOptions options;
    options.insertion = insertion;
    return options;
}

TEST(Slender, RodsNeedNoExemptions) {
    for (const Insertion insertion : {Insertion::OffCentre, Insertion::Circumcentre}) {
        for (const double length : {5.0, 20.0, 100.0}) {
            SCOPED_TRACE(length);
            const Result result = mesh_of(geometry::make_cylinder(1.0, length), with(insertion));
            expect_sound(result, 2, true);
            expect_angles(result, 25.0);
            EXPECT_TRUE(result.report.exempt.empty());
            EXPECT_LT(result.mesh.triangles.size(), 200 + 40 * length);
        }
    }
}

TEST(Slender, RingsNeedNoExemptions) {
    for (const double radius : {5.0, 20.0, 50.0}) {
        SCOPED_TRACE(radius);
        const Result result = mesh_of(geometry::make_torus(radius, 1.0));
        expect_sound(result, 0, true);
        expect_angles(result, 25.0);
        EXPECT_TRUE(result.report.exempt.empty());
        EXPECT_LT(result.mesh.triangles.size(), 500 + 160 * radius);
    }
}

/// At least three triangles are needed around an apex: each has a third of the total angle of the unrolled cone. Only
/// towards the apex may angles be below the bound; how far below that third is not guaranteed: 1.0 of 6 degrees at a
/// length of 20.
TEST(Slender, NeedlesAreExemptAtTheirApexOnly) {
    for (const double length : {3.0, 5.0, 20.0}) {
        SCOPED_TRACE(length);
        const Result result = mesh_of(geometry::make_cone(1.0, length));
        expect_sound(result, 2, true);
        expect_angles(result, 25.0);
        for (const auto& [t, why] : result.report.exempt) {
            double highest = 0.0;
            for (const Vec3& p : corners_of(result.mesh, t)) {
                highest = std::max(highest, p.z());
            }
            EXPECT_GT(highest, 0.5 * length) << mesh::message_of(why).text();
        }
    }
}

/// A cone with a narrow or wide slit along it, stretched: from the ends of the side of the parameter domain that is
/// its apex, triangles extended around the tip and through the slit.
TEST(Slender, TipsWithASlitDoNotReachRoundIt) {
    gp_GTrsf stretch;
    stretch.SetValue(1, 1, 0.37);
    stretch.SetValue(2, 2, 0.17);
    stretch.SetValue(3, 3, 0.65);
    for (const double slit : {0.1, 0.7}) {
        SCOPED_TRACE(slit);
        const TopoDS_Shape round = BRepPrimAPI_MakeCone(1.0, 0.0, 1.0, 2.0 * M_PI - slit).Shape();
        const Result result =
            mesh_of(geometry::make_shape_model(BRepBuilderAPI_GTransform(round, stretch, true).Shape()));
        expect_sound(result, 2, true);
        expect_angles(result, 25.0);
        EXPECT_TRUE(mesh::self_intersections(result.mesh.vertices, result.mesh.triangles).empty());
    }
}

}  // namespace
}  // namespace mq::triangulate

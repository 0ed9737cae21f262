// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/face_size_floors.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>

#include "geometry/occt/shape_model.h"
#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

TEST(FaceSizeFloors, RiseWithTheTrianglesThatAreGivenUp) {
    Pipeline pipeline(geometry::make_torus(5.0, 1.5));
    pipeline.refine(30.0);
    ASSERT_GT(pipeline.surface.triangle_count(), 400);
    FaceSizeFloors floors(pipeline.work);
    const double lowest = pipeline.work.shortest_allowed();
    const auto give_up = [&](int from, int to, Cause cause) {
        for (int t = from; t < to; ++t) {
            pipeline.work.exempt[t] = {cause, -1, -1, pipeline.surface.stamp(t)};
        }
        floors.check_after(static_cast<std::size_t>(to - from));
    };
    give_up(0, 100, Cause::Crowded);
    EXPECT_EQ(floors.of(0), lowest) << "tips have as many";
    give_up(100, 300, Cause::NarrowCorner);
    EXPECT_EQ(floors.of(0), lowest) << "these angles belong to the part";
    give_up(100, 250, Cause::Resolution);
    EXPECT_EQ(floors.of(0), 2.0 * lowest);
    give_up(100, 250, Cause::Resolution);
    EXPECT_EQ(floors.of(0), 2.0 * lowest) << "the same ones again";
    give_up(250, 400, Cause::Fold);
    give_up(400, pipeline.surface.triangle_count(), Cause::Crowded);
    EXPECT_EQ(floors.of(0), 2.0 * lowest) << "a narrow face has many of these until its border is divided";
    give_up(250, 350, Cause::Resolution);
    EXPECT_EQ(floors.of(0), 4.0 * lowest);
    EXPECT_EQ(floors.of(1), lowest);
}

/// The inside of the face has a point with no tangent plane, and around it the ring is narrower than any triangle.
TEST(FaceSizeFloors, ARingWithoutAHoleIsNoRunAway) {
    const gp_Circ circle(gp_Ax2(gp_Pnt(10.0, 0.0, 0.0), gp_Dir(0.0, 1.0, 0.0)), 10.0);
    const TopoDS_Face disc =
        BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire()).Face();
    const TopoDS_Shape ring = BRepPrimAPI_MakeRevol(disc, gp_Ax1(gp_Pnt(), gp_Dir(0.0, 0.0, 1.0))).Shape();
    TriangulateOptions options;
    options.insertion = Insertion::Circumcentre;
    const Result result = mesh_of(geometry::make_shape_model(ring, nullptr), options);
    EXPECT_TRUE(result.report.complete);
    EXPECT_TRUE(result.report.closed && result.report.oriented);
    EXPECT_LT(result.mesh.triangles.size(), 50000U);
}

/// A box of 1 m beside a face of two squares that a strip joins, 200 times as long as the least distance of vertices.
std::shared_ptr<geometry::Model> strip_beside_a_box(double width) {
    BRepBuilderAPI_MakePolygon outline;
    for (const auto& [x, y] : std::vector<std::array<double, 2>>{{0.0, -0.1},
                                                                 {0.2, -0.1},
                                                                 {0.2, -0.5 * width},
                                                                 {0.4, -0.5 * width},
                                                                 {0.4, -0.1},
                                                                 {0.6, -0.1},
                                                                 {0.6, 0.1},
                                                                 {0.4, 0.1},
                                                                 {0.4, 0.5 * width},
                                                                 {0.2, 0.5 * width},
                                                                 {0.2, 0.1},
                                                                 {0.0, 0.1}}) {
        outline.Add(gp_Pnt(x, y, 0.0));
    }
    outline.Close();
    TopoDS_Compound both;
    const BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 1.0), 1000.0, 1000.0, 1000.0).Shape());
    builder.Add(both, BRepBuilderAPI_MakeFace(outline.Wire()).Face());
    return geometry::make_shape_model(both, nullptr);
}

TEST(FaceSizeFloors, TheBoundaryOfAFaceTooNarrowForTheBoundIsNotDivided) {
    const double bound = 25.0 * M_PI / 180.0;
    const double floor = SinglePrecisionGrid(strip_beside_a_box(0.1)->topology().box).shortest_side();
    for (const double share : {0.5, 0.9, 2.1}) {
        SCOPED_TRACE(share);
        const Result result = mesh_of(strip_beside_a_box(share * floor * std::tan(bound)));
        for (const auto& [triangle, reason] : result.report.exempt) {
            EXPECT_EQ(reason.cause, Cause::Resolution);
        }
        std::size_t in_strip = 0;
        for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
            const auto corners = corners_of(result.mesh, t);
            in_strip += std::all_of(corners.begin(), corners.end(),
                                    [](const Vec3& p) { return p.z() < 0.5 && p.x() > 0.21 && p.x() < 0.39; });
        }
        if (share < 1.0) {
            EXPECT_GT(result.report.exempt.size(), 0U);
            EXPECT_LT(in_strip, 20U) << "only near its ends, where the face becomes wider";
        } else {
            EXPECT_TRUE(result.report.exempt.empty());
            EXPECT_GT(in_strip, 100U);
        }
    }
}

}  // namespace
}  // namespace mq::triangulate

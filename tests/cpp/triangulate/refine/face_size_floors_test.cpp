// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/face_size_floors.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
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
        floors.look(static_cast<std::size_t>(to - from));
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
    options.insertion = Insertion::Paper;
    const Result result = mesh_of(geometry::make_shape_model(ring, nullptr), options);
    EXPECT_TRUE(result.report.complete);
    EXPECT_TRUE(result.report.closed && result.report.oriented);
    EXPECT_LT(result.mesh.triangles.size(), 50000U);
}

}  // namespace
}  // namespace mq::triangulate

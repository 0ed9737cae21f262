// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/touching_edges.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>

#include "geometry/parts.h"

namespace mq::geometry {
namespace {

/// One solid of two boxes: the second one begins where x and y are 1 for the first one, moved by this along x.
TopoDS_Solid two_boxes(double apart, double x = 1.0) {
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    for (const double at : {0.0, 1.0}) {
        const gp_Pnt low(at * (x + apart), at, 0.0);
        for (TopExp_Explorer it(BRepPrimAPI_MakeBox(low, 1.0, 1.0, 2.0).Shape(), TopAbs_FACE); it.More(); it.Next()) {
            builder.Add(shell, it.Current());
        }
    }
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    return solid;
}

long edges_between_four_faces(const TopoDS_Shape& shape) {
    const auto model = make_shape_model(shape, nullptr, Creases::Keep, {[](const Box&) { return 1e-3; }});
    const std::vector<Edge>& edges = model->topology().edges;
    return std::count_if(edges.begin(), edges.end(), [](const Edge& edge) { return edge.uses.size() == 4; });
}

TEST(TouchingEdges, OfOneSolidAreOne) {
    const auto model = make_shape_model(two_boxes(0.0), nullptr, Creases::Keep, {[](const Box&) { return 1e-3; }});
    const Topology& topology = model->topology();
    EXPECT_EQ(edges_between_four_faces(two_boxes(0.0)), 1);
    ASSERT_FALSE(topology.joined.empty());
    EXPECT_TRUE(topology.joined.front().by_shape);
    const auto named = std::count_if(topology.faults.begin(), topology.faults.end(), [](const std::string& fault) {
        return fault.find("lie on each other, where the solid touches itself") != std::string::npos;
    });
    EXPECT_EQ(named, 1);
}

TEST(TouchingEdges, FartherApartThanTheirTolerancesStayTwo) {
    EXPECT_EQ(edges_between_four_faces(two_boxes(1e-5)), 0);
}

TEST(TouchingEdges, WhoseFacesLieOnEachOtherStayTwo) {
    EXPECT_EQ(edges_between_four_faces(two_boxes(0.0, 0.0)), 0);
}

TEST(TouchingEdges, OfTwoSolidsStayTwo) {
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 0.0), 1.0, 1.0, 2.0).Solid());
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(1.0, 1.0, 0.0), 1.0, 1.0, 2.0).Solid());
    EXPECT_EQ(edges_between_four_faces(both), 0);
}

}  // namespace
}  // namespace mq::geometry

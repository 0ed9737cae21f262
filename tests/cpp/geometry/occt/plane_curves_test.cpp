// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/plane_curves.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Pnt2d.hxx>

#include "geometry/parts.h"

namespace mq::geometry {
namespace {

int uses_without_stored_curve(const TopoDS_Shape& shape) {
    int count = 0;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
            double first = 0.0;
            double last = 0.0;
            Standard_Boolean stored = Standard_False;
            BRep_Tool::CurveOnSurface(TopoDS::Edge(edges.Current()), TopoDS::Face(faces.Current()), first, last,
                                      &stored);
            count += stored ? 0 : 1;
        }
    }
    return count;
}

/// A box with a bore, whose planes have no curves, twice at two places.
TopoDS_Compound two_bored_boxes() {
    const TopoDS_Shape part = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10.0, 10.0, 4.0).Shape(),
                                              moved_to(BRepPrimAPI_MakeCylinder(2.0, 20.0).Shape(), 4.0, 5.0, -4.0))
                                  .Shape();
    BRepTools::RemoveUnusedPCurves(part);
    for (TopExp_Explorer edges(part, TopAbs_EDGE); edges.More(); edges.Next()) {
        for (TopExp_Explorer faces(part, TopAbs_FACE); faces.More(); faces.Next()) {
            if (BRepAdaptor_Surface(TopoDS::Face(faces.Current())).GetType() == GeomAbs_Plane) {
                BRep_Builder().UpdateEdge(TopoDS::Edge(edges.Current()), Handle(Geom2d_Curve)(),
                                          TopoDS::Face(faces.Current()), 1e-7);
            }
        }
    }
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, part);
    builder.Add(both, moved_to(part, 30.0, -2.0, 7.0));
    return both;
}

TEST(PlaneCurves, AreThoseThatOpenCascadeProjects) {
    const TopoDS_Compound shape = two_bored_boxes();
    const int missing = uses_without_stored_curve(shape);
    ASSERT_GT(missing, 20);
    const TopoDS_Shape with = with_plane_curves(shape, nullptr);
    EXPECT_EQ(uses_without_stored_curve(with), 0);
    EXPECT_EQ(uses_without_stored_curve(shape), missing) << "the shape itself has changed";
    TopExp_Explorer other(with, TopAbs_FACE);
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next(), other.Next()) {
        TopExp_Explorer copy(other.Current(), TopAbs_EDGE);
        for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next(), copy.Next()) {
            gp_Pnt2d ends[4];
            BRep_Tool::UVPoints(TopoDS::Edge(edges.Current()), TopoDS::Face(faces.Current()), ends[0], ends[1]);
            BRep_Tool::UVPoints(TopoDS::Edge(copy.Current()), TopoDS::Face(other.Current()), ends[2], ends[3]);
            EXPECT_EQ(ends[0].Distance(ends[2]), 0.0);
            EXPECT_EQ(ends[1].Distance(ends[3]), 0.0);
            double range[4];
            const auto own = BRep_Tool::CurveOnSurface(TopoDS::Edge(edges.Current()), TopoDS::Face(faces.Current()),
                                                       range[0], range[1]);
            const auto same = BRep_Tool::CurveOnSurface(TopoDS::Edge(copy.Current()), TopoDS::Face(other.Current()),
                                                        range[2], range[3]);
            EXPECT_EQ(range[0], range[2]);
            EXPECT_EQ(range[1], range[3]);
            EXPECT_EQ(own->Value(range[0]).Distance(same->Value(range[0])), 0.0);
            EXPECT_EQ(edges.Current().Orientation(), copy.Current().Orientation());
        }
    }
}

TEST(PlaneCurves, KeepTheOrderAndWhatIsShared) {
    const TopoDS_Compound shape = two_bored_boxes();
    const TopoDS_Shape with = with_plane_curves(shape, nullptr);
    for (const TopAbs_ShapeEnum kind : {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_WIRE, TopAbs_FACE, TopAbs_SOLID}) {
        TopTools_IndexedMapOfShape before;
        TopTools_IndexedMapOfShape after;
        TopExp::MapShapes(shape, kind, before);
        TopExp::MapShapes(with, kind, after);
        ASSERT_EQ(before.Extent(), after.Extent());
        for (int i = 1; i <= before.Extent(); ++i) {
            EXPECT_EQ(before(i).Orientation(), after(i).Orientation());
            EXPECT_TRUE(before(i).Location() == after(i).Location());
            EXPECT_EQ(before(i).TShape() == before(1).TShape(), after(i).TShape() == after(1).TShape());
        }
    }
}

TEST(PlaneCurves, NothingIsCopiedWhereNoneIsMissing) {
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(2.0).Shape();
    EXPECT_TRUE(with_plane_curves(sphere, nullptr).IsEqual(sphere));
    Progress progress;
    progress.cancel();
    EXPECT_THROW(with_plane_curves(sphere, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/inside_out.h"

#include <gtest/gtest.h>

#include <Geom_BezierSurface.hxx>
#include <Standard_NumericError.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "geometry/parts.h"

namespace mq::geometry {
namespace {

/// Solids with plane and curved faces, with and without holes.
std::vector<TopoDS_Shape> solids() {
    return {BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(),
            BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape(),
            BRepPrimAPI_MakeSphere(2.0).Shape(),
            BRepPrimAPI_MakeCone(2.0, 0.5, 5.0).Shape(),
            BRepPrimAPI_MakeTorus(5.0, 1.5).Shape(),
            moved_to(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(), 4.0, 5.0, 6.0),
            holed_plate(),
            curved_plate(),
            wedge(20.0, 5.0, 1.0)};
}

TEST(InsideOut, RaysShowThatSolidsLookOutward) {
    for (const TopoDS_Shape& shape : solids()) {
        const TopoDS_Shape solid = TopExp_Explorer(shape, TopAbs_SOLID).Current();
        EXPECT_TRUE(looks_outward(solid));
        EXPECT_FALSE(is_inside_out(solid));
        EXPECT_FALSE(looks_outward(solid.Reversed()));
        EXPECT_TRUE(is_inside_out(solid.Reversed()));
    }
}

TEST(InsideOut, NoRayContradictsOpenCascade) {
    for (const char* name : {"blade", "bored", "doubled_edge", "filleted_box", "fused"}) {
        for (TopExp_Explorer solids(stored(name), TopAbs_SOLID); solids.More(); solids.Next()) {
            EXPECT_FALSE(looks_outward(solids.Current()) && is_inside_out(solids.Current())) << name;
            EXPECT_FALSE(looks_outward(solids.Current().Reversed()) && !is_inside_out(solids.Current())) << name;
        }
    }
}

/// A surface that cannot be evaluated.
class Failing : public Geom_BezierSurface {
  public:
    Failing() : Geom_BezierSurface(corners()) {}
    void D0(Standard_Real, Standard_Real, gp_Pnt&) const override { throw Standard_NumericError("no point"); }
    void D1(Standard_Real, Standard_Real, gp_Pnt&, gp_Vec&, gp_Vec&) const override {
        throw Standard_NumericError("no derivatives");
    }

  private:
    static TColgp_Array2OfPnt corners() {
        TColgp_Array2OfPnt points(1, 2, 1, 2);
        points(1, 1) = gp_Pnt(0.0, 0.0, 0.0);
        points(1, 2) = gp_Pnt(0.0, 1.0, 0.0);
        points(2, 1) = gp_Pnt(1.0, 0.0, 0.0);
        points(2, 2) = gp_Pnt(1.0, 1.0, 1.0);
        return points;
    }
};

TEST(InsideOut, AFaceOnWhichOpenCascadeFailsShowsNothing) {
    const BRep_Builder builder;
    const TopoDS_Face face =
        BRepBuilderAPI_MakeFace(Handle(Geom_Surface)(new Geom_BezierSurface(Failing())), 1e-7).Face();
    builder.UpdateFace(face, new Failing(), TopLoc_Location(), 1e-7);
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    builder.Add(shell, face);
    EXPECT_FALSE(looks_outward(shell));
}

TEST(InsideOut, EveryPlaceOfAnInvertedSolidIsNamed) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Solid().Reversed();
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, box);
    builder.Add(both, moved_to(box, 10.0, 0.0, 0.0));
    builder.Add(both, moved_to(box.Reversed(), 20.0, 0.0, 0.0));
    const std::vector<std::string> faults = make_shape_model(both)->topology().faults;
    EXPECT_EQ(std::count(faults.begin(), faults.end(), "Solid1: is turned inside out"), 1);
    EXPECT_EQ(std::count(faults.begin(), faults.end(), "Solid2: is turned inside out"), 1);
    EXPECT_EQ(std::count(faults.begin(), faults.end(), "Solid3: is turned inside out"), 0);
}

}  // namespace
}  // namespace mq::geometry

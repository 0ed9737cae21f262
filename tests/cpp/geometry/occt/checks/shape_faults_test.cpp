// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Standard_NumericError.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/occt/shape_model.h"

namespace mq::geometry {
namespace {

/// Edges of a face that is left to OpenCASCADE; the faults found must be the same for both numbers.
constexpr int kFew = 60;
/// Edges of a face that is checked in linear time.
constexpr int kMany = 600;

struct Gear {
    TopoDS_Face face;
    std::vector<TopoDS_Vertex> corners;
};

/// A plane face with teeth; the last `missing` edges are left out.
Gear gear(int edges, int missing = 0) {
    BRep_Builder builder;
    Gear made;
    for (int i = 0; i < edges; ++i) {
        const double radius = i % 2 == 0 ? 100.0 : 103.0;
        const double turn = 2.0 * M_PI * i / edges;
        made.corners.emplace_back();
        builder.MakeVertex(made.corners.back(), gp_Pnt(radius * std::cos(turn), radius * std::sin(turn), 0.0), 1e-7);
    }
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (int i = 0; i + missing < edges; ++i) {
        builder.Add(wire, BRepBuilderAPI_MakeEdge(made.corners[i], made.corners[(i + 1) % edges]).Edge());
    }
    made.face = TopoDS::Face(BRepBuilderAPI_MakeFace(gp_Pln()).Face().EmptyCopied());
    builder.Add(made.face, wire);
    return made;
}

std::vector<std::string> faults_of(const TopoDS_Shape& shape) {
    return make_shape_model(shape, nullptr)->topology().faults;
}

/// The number of lines that begin with `entity` and end in `what`.
int count(const std::vector<std::string>& faults, const std::string& entity, const std::string& what) {
    int found = 0;
    for (const std::string& line : faults) {
        found += line.rfind(entity, 0) == 0 && line.size() >= what.size() &&
                         line.compare(line.size() - what.size(), what.size(), what) == 0
                     ? 1
                     : 0;
    }
    return found;
}

TEST(ShapeFaults, NothingIsWrongWithManyEdges) {
    for (const int edges : {kFew, kMany}) {
        EXPECT_EQ(faults_of(gear(edges).face), std::vector<std::string>()) << edges;
        EXPECT_EQ(faults_of(BRepPrimAPI_MakePrism(gear(edges).face, gp_Vec(0.0, 0.0, 5.0)).Shape()),
                  std::vector<std::string>())
            << edges;
    }
}

TEST(ShapeFaults, VerticesOffTheirEdgesAreNamed) {
    for (const int edges : {kFew, kMany}) {
        const Gear made = gear(edges);
        BRep_Builder().UpdateVertex(made.corners[7], gp_Pnt(50.0, 0.0, 0.0), 1e-7);
        const std::vector<std::string> faults = faults_of(made.face);
        EXPECT_EQ(count(faults, "Vertex8 in Edge7", "invalid point on curve"), 1) << edges;
    }
}

TEST(ShapeFaults, OpenWiresAreNamed) {
    for (const int edges : {kFew, kMany}) {
        EXPECT_EQ(count(faults_of(gear(edges, 1).face), "Wire1 in Face1", "not closed"), 1) << edges;
    }
}

/// A prism without its last face.
TEST(ShapeFaults, OpenShellsOfSolidsAreNamed) {
    for (const int edges : {kFew, kMany}) {
        const TopoDS_Shape prism = BRepPrimAPI_MakePrism(gear(edges).face, gp_Vec(0.0, 0.0, 5.0)).Shape();
        BRep_Builder builder;
        TopoDS_Shell shell;
        builder.MakeShell(shell);
        int left = edges + 1;
        for (TopExp_Explorer faces(prism, TopAbs_FACE); left > 0; faces.Next(), --left) {
            builder.Add(shell, faces.Current());
        }
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, shell);
        const std::vector<std::string> faults = faults_of(solid);
        EXPECT_EQ(count(faults, "Shell1", "not closed"), 1) << edges;
    }
}

/// A line that cannot be evaluated at one of the calls.
class FailsOnce : public Geom2d_Line {
  public:
    using Geom2d_Line::Geom2d_Line;
    void fail_at(int call) { left_ = call; }
    void D0(Standard_Real t, gp_Pnt2d& p) const override {
        if (left_ > 0 && --left_ == 0) {
            left_ = -1;
            throw Standard_NumericError("no point");
        }
        Geom2d_Line::D0(t, p);
    }
    bool has_failed() const { return left_ < 0; }

  private:
    mutable int left_ = 0;
};

TEST(ShapeFaults, AProofThatFailsIsNoFault) {
    int failed = 0;
    for (int call = 1; call < 40; ++call) {
        const TopoDS_Face face = TopoDS::Face(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).TopFace());
        const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current());
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
        gp_Pnt2d start;
        gp_Vec2d along;
        curve->D1(0.0, start, along);
        const Handle(FailsOnce) line = new FailsOnce(start, gp_Dir2d(along));
        BRep_Builder().UpdateEdge(edge, line, face, 1e-7);
        line->fail_at(call);
        std::vector<std::string> faults;
        try {
            faults = faults_of(face);
        } catch (const GeometryError&) {
            continue;  // failed while the shape was read
        }
        EXPECT_EQ(count(faults, "Face1: OpenCASCADE's check ended", ""), 0) << call;
        failed += line->has_failed() && faults.empty() ? 1 : 0;
    }
    EXPECT_GT(failed, 0);
}

TEST(ShapeFaults, CancelledChecksEnd) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(make_shape_model(gear(kMany).face, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::geometry

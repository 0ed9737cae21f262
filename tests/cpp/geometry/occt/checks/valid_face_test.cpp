// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/checks/valid_face.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRepTools_ReShape.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <random>

#include "geometry/occt/plane_curves.h"
#include "geometry/parts.h"

namespace mq::geometry {
namespace {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> result;
    const TopoDS_Shape with = with_plane_curves(shape, nullptr);
    for (TopExp_Explorer faces(with, TopAbs_FACE); faces.More(); faces.Next()) {
        result.push_back(TopoDS::Face(faces.Current().Located(TopLoc_Location())));
    }
    return result;
}

/// Those proved valid, after a test that OpenCASCADE finds nothing against any of them.
int count_proved(const std::vector<TopoDS_Face>& faces) {
    int count = 0;
    for (const TopoDS_Face& face : faces) {
        const bool proved = is_proved_valid(face);
        EXPECT_TRUE(!proved || BRepCheck_Analyzer(face).IsValid());
        count += proved ? 1 : 0;
    }
    return count;
}

/// A plane face between wires of straight edges.
TopoDS_Face polygons(const std::vector<std::vector<gp_Pnt>>& wires) {
    const BRep_Builder builder;
    TopoDS_Face face;
    builder.MakeFace(face, new Geom_Plane(gp_Pln()), 1e-7);
    for (const std::vector<gp_Pnt>& points : wires) {
        BRepBuilderAPI_MakePolygon polygon;
        for (const gp_Pnt& p : points) {
            polygon.Add(p);
        }
        polygon.Close();
        builder.Add(face, polygon.Wire());
    }
    return faces_of(face).front();
}

/// The same with rational splines in place of lines and circles.
TopoDS_Shape as_splines(const TopoDS_Shape& shape) {
    return BRepBuilderAPI_NurbsConvert(shape, Standard_True).Shape();
}

std::vector<gp_Pnt> square(double x, double y, double side, bool hole) {
    std::vector<gp_Pnt> points{gp_Pnt(x, y, 0.0), gp_Pnt(x + side, y, 0.0), gp_Pnt(x + side, y + side, 0.0),
                               gp_Pnt(x, y + side, 0.0)};
    if (hole) {
        std::reverse(points.begin(), points.end());
    }
    return points;
}

TEST(ValidFace, ProvesFacesOfSolids) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    EXPECT_EQ(count_proved(faces_of(box)), 6);
    EXPECT_EQ(count_proved(faces_of(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape())), 3);
    EXPECT_EQ(count_proved(faces_of(BRepPrimAPI_MakeSphere(2.0).Shape())), 1);
    count_proved(faces_of(BRepPrimAPI_MakeTorus(5.0, 1.0).Shape()));
    EXPECT_EQ(count_proved(faces_of(holed_plate())), static_cast<int>(faces_of(holed_plate()).size()));
    EXPECT_GT(count_proved(faces_of(as_splines(holed_plate()))), 3);
    const std::vector<TopoDS_Face> filleted = faces_of(stored("filleted_box"));
    EXPECT_GT(2 * count_proved(filleted), static_cast<int>(filleted.size()));
    for (const char* name : {"blade", "bored", "doubled_edge", "fused"}) {
        count_proved(faces_of(stored(name)));
    }
}

TEST(ValidFace, HolesLieBesideEachOtherInside) {
    const std::vector<gp_Pnt> outer = square(0.0, 0.0, 10.0, false);
    EXPECT_TRUE(is_proved_valid(polygons({outer, square(1.0, 1.0, 2.0, true), square(5.0, 5.0, 3.0, true)})));
    EXPECT_FALSE(is_proved_valid(polygons({outer, square(1.0, 1.0, 2.0, false)})));  // turned
    EXPECT_FALSE(is_proved_valid(polygons({outer, square(9.0, 1.0, 2.0, true)})));   // across the boundary
    EXPECT_FALSE(is_proved_valid(polygons({outer, square(20.0, 1.0, 2.0, true)})));  // outside
    EXPECT_FALSE(is_proved_valid(polygons({outer, square(1.0, 1.0, 6.0, true), square(2.0, 2.0, 1.0, true)})));
    EXPECT_FALSE(is_proved_valid(polygons({square(0.0, 0.0, 10.0, true)})));          // all but a square
    EXPECT_FALSE(is_proved_valid(polygons({outer, square(20.0, 0.0, 5.0, false)})));  // two faces
}

/// A square with a hole at (9, `y`) beside its first edge, which ends this high above the place where the next starts.
TopoDS_Face with_gap(double gap, double y) {
    const BRep_Builder builder;
    const TopoDS_Face face = polygons({square(0.0, 0.0, 10.0, false), square(9.0, y, 0.1 * std::abs(gap), true)});
    TopExp_Explorer edges(face, TopAbs_EDGE);
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    const gp_Dir along(10.0, gap, 0.0);
    builder.UpdateEdge(edge, new Geom_Line(gp_Pnt(), along), 1e-7);
    builder.UpdateEdge(edge, new Geom2d_Line(gp_Pnt2d(), gp_Dir2d(along.X(), along.Y())), face, 1e-7);
    for (TopExp_Explorer corners(edge, TopAbs_VERTEX); corners.More(); corners.Next()) {
        builder.UpdateVertex(TopoDS::Vertex(corners.Current()), 2.0 * std::abs(gap));
    }
    return face;
}

TEST(ValidFace, HolesBesideGapsLieWhereTheEdgesRun) {
    EXPECT_TRUE(is_proved_valid(with_gap(0.009, 2.0)));
    EXPECT_TRUE(is_proved_valid(with_gap(-0.009, -0.004)));
    EXPECT_FALSE(BRepCheck_Analyzer(with_gap(0.009, 0.004)).IsValid());
    EXPECT_FALSE(is_proved_valid(with_gap(0.009, 0.004)));
}

TEST(ValidFace, NoPolygonThatOpenCascadeRefusesIsProved) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> place(0, 12);
    int proofs = 0;
    int faulty = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<gp_Pnt> points;
        for (int i = 0; i < 3 + round % 4; ++i) {
            const gp_Pnt p(place(random), place(random), 0.0);
            if (std::none_of(points.begin(), points.end(), [&](const gp_Pnt& q) { return p.Distance(q) < 0.5; })) {
                points.push_back(p);
            }
        }
        if (points.size() < 3) {
            continue;
        }
        const TopoDS_Face face = polygons({points});
        const bool valid = BRepCheck_Analyzer(face).IsValid();
        const bool proved = is_proved_valid(face);
        EXPECT_TRUE(valid || !proved) << round;
        proofs += proved ? 1 : 0;
        faulty += valid ? 0 : 1;
    }
    EXPECT_GT(proofs, 500);
    EXPECT_GT(faulty, 500);
}

/// The face with one of its edges changed.
TopoDS_Face damaged(const TopoDS_Face& face, std::mt19937& random) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(face, TopAbs_EDGE, edges);
    const TopoDS_Edge edge =
        TopoDS::Edge(edges(1 + static_cast<int>(random() % static_cast<unsigned>(edges.Extent()))));
    const double size = std::pow(10.0, -1.0 - static_cast<double>(random() % 8));
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    TopoDS_Face result = face;
    BRepTools_ReShape change;
    switch (random() % 4) {
        case 0:  // its curve on the surface is elsewhere
            BRep_Builder().UpdateEdge(
                edge, Handle(Geom2d_Curve)::DownCast(curve->Translated(gp_Vec2d(size, -0.5 * size))), face, 0.0);
            break;
        case 1:
            BRep_Builder().Range(edge, first, last - size * (last - first));
            break;
        case 2:
            change.Remove(edge);
            result = TopoDS::Face(change.Apply(face));
            break;
        default:
            change.Replace(edge, edge.Reversed());
            result = TopoDS::Face(change.Apply(face));
    }
    return result;
}

TEST(ValidFace, NoDamagedFaceThatOpenCascadeRefusesIsProved) {
    std::mt19937 random(7);
    int faulty = 0;
    for (int round = 0; round < 40; ++round) {
        for (const TopoDS_Shape& shape :
             {TopoDS_Shape(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape()),
              TopoDS_Shape(BRepPrimAPI_MakeSphere(2.0).Shape()), TopoDS_Shape(BRepPrimAPI_MakeTorus(5.0, 1.0).Shape()),
              TopoDS_Shape(BRepPrimAPI_MakeCone(2.0, 0.0, 5.0).Shape()), holed_plate(), curved_plate(),
              as_splines(holed_plate()), as_splines(curved_plate()), stored("filleted_box"), stored("bored")}) {
            for (const TopoDS_Face& face : faces_of(shape)) {
                const TopoDS_Face bad = damaged(face, random);
                const bool valid = BRepCheck_Analyzer(bad).IsValid();
                EXPECT_TRUE(valid || !is_proved_valid(bad));
                faulty += valid ? 0 : 1;
            }
        }
    }
    EXPECT_GT(faulty, 500);
}

}  // namespace
}  // namespace mq::geometry

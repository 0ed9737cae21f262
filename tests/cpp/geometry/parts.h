// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <cmath>
#include <fstream>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/analytic/analytic_model.h"
#include "geometry/occt/brep_text.h"
#include "geometry/shapes.h"
#include "paths.h"

/// The shapes on which triangulations are tested.
namespace mq::geometry {

struct Part {
    std::string name;
    std::shared_ptr<Model> model;
    long euler;  ///< V - E + F, summed over its volumes
    bool closed;
};

inline TopoDS_Face planar_face(const std::vector<TopoDS_Edge>& border) {
    BRepBuilderAPI_MakeWire wire;
    for (const TopoDS_Edge& edge : border) {
        wire.Add(edge);
    }
    return BRepBuilderAPI_MakeFace(wire.Wire(), Standard_True).Face();
}

inline TopoDS_Shape extruded(const TopoDS_Shape& base, double height) {
    return BRepPrimAPI_MakePrism(base, gp_Vec(0.0, 0.0, height)).Shape();
}

inline TopoDS_Edge arc(const gp_Circ& circle, double from, double to) {
    return BRepBuilderAPI_MakeEdge(circle, from, to).Edge();
}

inline gp_Circ circle_about(double x, double y, double radius) {
    return gp_Circ(gp_Ax2(gp_Pnt(x, y, 0.0), gp_Dir(0.0, 0.0, 1.0)), radius);
}

inline TopoDS_Edge line(double x0, double y0, double x1, double y1) {
    return BRepBuilderAPI_MakeEdge(gp_Pnt(x0, y0, 0.0), gp_Pnt(x1, y1, 0.0)).Edge();
}

/// A prism over an isosceles triangle with the given angle at the origin.
inline TopoDS_Shape wedge(double degrees, double length, double height) {
    const double half = degrees * M_PI / 360.0;
    BRepBuilderAPI_MakePolygon polygon(gp_Pnt(0.0, 0.0, 0.0),
                                       gp_Pnt(length * std::cos(half), -length * std::sin(half), 0.0),
                                       gp_Pnt(length * std::cos(half), length * std::sin(half), 0.0), Standard_True);
    return extruded(BRepBuilderAPI_MakeFace(polygon.Wire(), Standard_True).Face(), height);
}

/// Between two circles that touch in the origin, and a line that touches both: three angles of zero.
inline TopoDS_Face cusp() {
    return planar_face({arc(circle_about(0.0, -4.0, 4.0), 0.0, 0.5 * M_PI), line(4.0, -4.0, 4.0, 4.0),
                        arc(circle_about(0.0, 4.0, 4.0), 1.5 * M_PI, 2.0 * M_PI)});
}

/// Between two arcs that touch in the origin and turn by the given angles from there.
inline TopoDS_Face crescent(double inner_radius, double outer_radius, double inner_turn, double outer_turn) {
    const gp_Circ inner = circle_about(0.0, inner_radius, inner_radius);
    const gp_Circ outer = circle_about(0.0, outer_radius, outer_radius);
    const auto to = [](double turn) { return -M_PI / 2.0 + turn * M_PI / 180.0; };
    const TopoDS_Edge first = arc(outer, to(0.0), to(outer_turn));
    const TopoDS_Edge second = arc(inner, to(0.0), to(inner_turn));
    const auto end_of = [&](const gp_Circ& circle, double turn) {
        return Vec2(circle.Radius() * std::cos(to(turn)), circle.Radius() * (1.0 + std::sin(to(turn))));
    };
    const Vec2 a = end_of(outer, outer_turn);
    const Vec2 b = end_of(inner, inner_turn);
    return planar_face({first, line(a.x(), a.y(), b.x(), b.y()), second});
}

/// Two arcs about one centre, close together against their length.
inline TopoDS_Shape curved_plate() {
    const double from = -1.2;
    const double to = 1.4;
    const auto ray = [](double angle) {
        return line(10.0 * std::cos(angle), 10.0 * std::sin(angle), 10.3 * std::cos(angle), 10.3 * std::sin(angle));
    };
    return extruded(planar_face({arc(circle_about(0.0, 0.0, 10.0), from, to), ray(to),
                                 arc(circle_about(0.0, 0.0, 10.3), from, to), ray(from)}),
                    1.0);
}

/// A plate with a round hole, extruded from a face with two loops.
inline TopoDS_Shape holed_plate() {
    BRepBuilderAPI_MakePolygon outer(gp_Pnt(-5.0, -4.0, 0.0), gp_Pnt(5.0, -4.0, 0.0), gp_Pnt(5.0, 4.0, 0.0),
                                     gp_Pnt(-5.0, 4.0, 0.0), Standard_True);
    const TopoDS_Wire hole =
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle_about(1.0, 0.5, 2.0)).Edge()).Wire();
    BRepBuilderAPI_MakeFace face(outer.Wire(), Standard_True);
    face.Add(TopoDS::Wire(hole.Reversed()));
    return extruded(face.Face(), 3.0);
}

/// The first `count` faces of a shape as a shell of their own.
inline TopoDS_Shell shell_of(const TopoDS_Shape& shape, int count) {
    BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    TopExp_Explorer it(shape, TopAbs_FACE);
    for (int i = 0; i < count; ++i, it.Next()) {
        builder.Add(shell, it.Current());
    }
    return shell;
}

/// Two solids with one face in common: the prism of a shell of two faces of a box that meet at an edge.
inline TopoDS_Shape twin_solids() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Shape();
    BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    TopExp_Explorer it(box, TopAbs_FACE);
    builder.Add(shell, it.Current());  // x = 0
    it.Next();
    it.Next();
    builder.Add(shell, it.Current());  // y = 0
    return BRepPrimAPI_MakePrism(shell, gp_Vec(-3.0, -3.0, 0.0)).Shape();
}

inline TopoDS_Shape moved_to(const TopoDS_Shape& shape, double x, double y, double z) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1.0, 0.0, 2.0), gp_Dir(1.0, 2.0, -1.0)), 0.7);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(x, y, z));
    return shape.Located(TopLoc_Location(move * turn), Standard_False);
}

inline TopoDS_Shape mirrored(const TopoDS_Shape& shape) {
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(3.0, 1.0, 0.0), gp_Dir(1.0, 1.0, 0.3)));
    return shape.Located(TopLoc_Location(mirror), Standard_False);
}

inline TopoDS_Shape scaled(const TopoDS_Shape& shape, double factor) {
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(0.0, 0.0, 0.0), factor);
    return BRepBuilderAPI_Transform(shape, scale, Standard_True).Shape();
}

/// A shape that a modeler made and wrote, from the folder beside this header.
inline TopoDS_Shape stored(const std::string& name) {
    std::ifstream file(stored_parts() + "/" + name + ".brep");
    EXPECT_TRUE(file) << name;
    std::ostringstream text;
    text << file.rdbuf();
    return *read_brep_text(text.str());
}

inline Part solid(const std::string& name, const TopoDS_Shape& shape, long euler = 2) {
    return {name, make_shape_model(shape), euler, true};
}

inline std::vector<Part> analytic_parts() {
    return {{"analytic sphere", make_sphere(2.0), 2, true},
            {"analytic cylinder", make_cylinder(2.0, 5.0), 2, true},
            {"analytic cone", make_cone(2.0, 5.0), 2, true},
            {"analytic torus", make_torus(5.0, 1.5), 0, true},
            {"analytic box", make_box(1.0, 2.0, 3.0), 2, true}};
}

inline std::vector<Part> shape_parts() {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape();
    const TopoDS_Shape frustum = BRepPrimAPI_MakeCone(3.0, 1.0, 4.0).Shape();
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(5.0, 1.5).Shape();
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    return {solid("box", box),
            solid("cylinder", cylinder),
            solid("sphere", BRepPrimAPI_MakeSphere(2.0).Shape()),
            solid("cone", BRepPrimAPI_MakeCone(2.0, 0.0, 5.0).Shape()),
            solid("frustum", frustum),
            solid("torus", torus, 0),
            solid("fused box and cylinder", stored("fused")),
            solid("filleted box", stored("filleted_box")),
            solid("bored box", stored("bored"), 0),
            solid("holed plate", holed_plate(), 0),
            solid("curved plate", curved_plate()),
            solid("mirrored frustum", mirrored(frustum)),
            solid("moved torus", moved_to(torus, 10.0, -3.0, 4.0), 0),
            solid("scaled cylinder", scaled(cylinder, 12.5)),
            solid("twin solids", twin_solids(), 4),
            {"open shell", make_shape_model(shell_of(box, 5)), 1, false},
            {"loose round face", make_shape_model(shell_of(cylinder, 1)), 0, false},
            {"cusp", make_shape_model(cusp()), 1, false}};
}

inline std::vector<Part> all_parts() {
    std::vector<Part> parts = analytic_parts();
    const std::vector<Part> shapes = shape_parts();
    parts.insert(parts.end(), shapes.begin(), shapes.end());
    return parts;
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Random solids of a few primitives, cut, joined and moved by OpenCASCADE, meshed with random options: the mesh keeps
// what triangulate promises, or there is an error with a reason.
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <set>

#include "base/error.h"
#include "bytes.h"
#include "geometry/engine.h"
#include "geometry/occt/shape_model.h"
#include "mesh/quality/triangle_quality.h"
#include "triangulate/triangulate.h"

namespace mq {
namespace {

double length(fuzz::Bytes& bytes) {
    constexpr double kUnit = 0.5;
    return kUnit * bytes.number(1, 12);
}

TopoDS_Shape primitive(fuzz::Bytes& bytes) {
    const double a = length(bytes);
    const double b = length(bytes);
    const double c = length(bytes);
    switch (bytes.number(0, 5)) {
        case 0:
            return BRepPrimAPI_MakeBox(a, b, c).Shape();
        case 1:
            return BRepPrimAPI_MakeCylinder(a, b).Shape();
        case 2:
            return BRepPrimAPI_MakeCone(a, a == b ? 0.0 : b, c).Shape();
        case 3:
            return BRepPrimAPI_MakeSphere(a).Shape();
        case 4:
            return BRepPrimAPI_MakeTorus(a + b, a).Shape();
        default:
            return BRepPrimAPI_MakeWedge(a, b, c, 0.5 * a).Shape();
    }
}

TopoDS_Shape moved(const TopoDS_Shape& shape, fuzz::Bytes& bytes) {
    const int quarters = bytes.number(0, 7);
    gp_Trsf turn;
    const double angle = quarters < 6 ? 0.25 * M_PI * quarters : bytes.part(0.0, M_PI);
    // Braces, as the order of arguments in parentheses is the compiler's choice.
    turn.SetRotation(gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir{bytes.number(0, 1) * 1.0, bytes.number(0, 1) * 1.0, 1.0}),
                     angle);
    gp_Trsf move;
    move.SetTranslation(gp_Vec{0.5 * bytes.number(-8, 8), 0.5 * bytes.number(-8, 8), 0.5 * bytes.number(-8, 8)});
    return shape.Located(TopLoc_Location(move * turn), Standard_False);
}

TopoDS_Shape joined(const TopoDS_Shape& a, const TopoDS_Shape& b, int operation) {
    switch (operation) {
        case 0:
            return BRepAlgoAPI_Cut(a, b).Shape();
        case 1:
            return BRepAlgoAPI_Fuse(a, b).Shape();
        default:
            return BRepAlgoAPI_Common(a, b).Shape();
    }
}

TopoDS_Shape solid(fuzz::Bytes& bytes) {
    TopoDS_Shape shape = primitive(bytes);
    for (int i = bytes.number(0, 2); i > 0; --i) {
        const TopoDS_Shape tool = moved(primitive(bytes), bytes);
        shape = joined(shape, tool, bytes.number(0, 2));
    }
    return moved(shape, bytes);
}

triangulate::TriangulateOptions options_from(fuzz::Bytes& bytes) {
    constexpr std::size_t kBudget = 4000;  // triangles: a few tenths of a second
    triangulate::TriangulateOptions options;
    options.max_triangles = kBudget;
    options.min_angle = bytes.part(5.0, 33.0);
    const int bounds = bytes.number(0, 31);
    if ((bounds & 1) != 0) {
        options.chord_height_relative = bytes.part(0.005, 0.1);
    }
    if ((bounds & 2) != 0) {
        options.max_edge = bytes.part(0.5, 8.0);
    }
    if ((bounds & 4) != 0) {
        options.edges_per_circle = bytes.part(3.0, 24.0);
    }
    if ((bounds & 8) != 0) {
        options.growth = bytes.part(1.1, 3.0);
    }
    if ((bounds & 16) != 0) {
        options.keep_edges = triangulate::KeepEdges::Feature;
    }
    options.insertion =
        bytes.number(0, 3) == 0 ? triangulate::Insertion::Circumcentre : triangulate::Insertion::OffCentre;
    return options;
}

void check_angles(const triangulate::Result& result, double bound) {
    constexpr double kAngleRounding = 1e-6;
    std::set<std::int32_t> exempt;
    for (const auto& [t, reason] : result.report.exempt) {
        fuzz::require(t >= 0 && static_cast<std::size_t>(t) < result.mesh.triangles.size(),
                      "an exempt triangle is there");
        exempt.insert(t);
    }
    const auto& vertices = result.mesh.vertices;
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        const mesh::Triangle& v = result.mesh.triangles[t];
        fuzz::require(
            exempt.count(static_cast<std::int32_t>(t)) > 0 ||
                mesh::min_angle_of({vertices[v[0]], vertices[v[1]], vertices[v[2]]}) >= bound - kAngleRounding,
            "triangles below the angle are listed");
    }
}

/// Whether OpenCASCADE calls it a valid solid, its shells are closed, which that does not ask, and its vertices lie on
/// their edges: Booleans left one 11 mm off on a part of 32 mm, between two arcs with a gap.
bool is_closed_solid(const TopoDS_Shape& shape) {
    constexpr double kLargest = 0.05;  // mm, a tenth of the shortest length of a primitive
    for (TopExp_Explorer vertex(shape, TopAbs_VERTEX); vertex.More(); vertex.Next()) {
        if (BRep_Tool::Tolerance(TopoDS::Vertex(vertex.Current())) > kLargest) {
            return false;
        }
    }
    for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
        if (!BRep_Tool::IsClosed(shell.Current())) {
            return false;
        }
    }
    return TopExp_Explorer(shape, TopAbs_SOLID).More() && BRepCheck_Analyzer(shape).IsValid();
}

void check(const TopoDS_Shape& shape, const triangulate::TriangulateOptions& options) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    const auto model = geometry::make_shape_model(shape);
    const triangulate::Result result = triangulate::triangulate(engine, model, options);
    const mesh::MeshReport measured = mesh::measure(result.mesh);
    fuzz::require(measured.closed == result.report.closed && measured.manifold == result.report.manifold &&
                      measured.oriented == result.report.oriented,
                  "the report says what is measured");
    for (const Vec3& p : result.mesh.vertices) {
        fuzz::require(is_single(p), "coordinates are single-precision numbers");
    }
    fuzz::require(result.mesh.triangle_face.size() == result.mesh.triangles.size(), "every triangle has a face");
    fuzz::require(measured.degenerate_triangles == 0, "no triangle is degenerate");
    // An edge of four triangles, where solids of a compound share an edge, counts as misoriented.
    fuzz::require(
        !is_closed_solid(shape) || (measured.closed && measured.misoriented_edges == measured.nonmanifold_edges),
        "the mesh of a valid solid is closed");
    // Where the budget ends the work the report says it is incomplete, and lists nothing.
    if (result.report.complete) {
        check_angles(result, options.min_angle);
    }
}

}  // namespace
}  // namespace mq

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace mq;
    fuzz::Bytes bytes(data, size);
    const triangulate::TriangulateOptions options = options_from(bytes);
    TopoDS_Shape shape;
    try {
        shape = solid(bytes);
    } catch (const Standard_Failure&) {
        // OpenCASCADE makes no such solid.
        return 0;
    }
    if (!TopExp_Explorer(shape, TopAbs_FACE).More()) {
        return 0;
    }
    try {
        check(shape, options);
    } catch (const Error&) {
        // The shape was refused with a sentence.
    }
    return 0;
}

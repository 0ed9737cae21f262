// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/stream/shape_stream.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <cstddef>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Hypr.hxx>
#include <gp_Parab.hxx>
#include <gp_Trsf.hxx>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/assemblies.h"

namespace mq::geometry {
namespace {

gp_Ax2 slanted() {
    return {gp_Pnt(0.1, 0.2, 0.3), gp_Dir(1.0, 2.0, 3.0), gp_Dir(0.7, -0.2, 0.1)};
}

TopLoc_Location turned(double angle) {
    gp_Trsf motion;
    motion.SetRotation(gp_Ax1(gp_Pnt(1.0, 2.0, 3.0), gp_Dir(0.3, -0.5, 0.7)), angle);
    return TopLoc_Location(motion);
}

TopoDS_Shape swept(const TopoDS_Edge& edge) {
    return BRepPrimAPI_MakePrism(edge, gp_Vec(0.3, 0.1, 5.0)).Shape();
}

Handle(Geom_Surface) saddle() {
    TColgp_Array2OfPnt poles(1, 3, 1, 3);
    for (int i = 1; i <= 3; ++i) {
        for (int j = 1; j <= 3; ++j) {
            poles(i, j) = gp_Pnt(i, j, 0.1 * i * j);
        }
    }
    return new Geom_BezierSurface(poles);
}

TopoDS_Shape face_of(const Handle(Geom_Surface) & surface) {
    return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

TopoDS_Shape face_of_triangles() {
    Handle(Poly_Triangulation) triangles = new Poly_Triangulation(3, 1, false);
    triangles->SetNode(1, gp_Pnt(0.0, 0.0, 0.0));
    triangles->SetNode(2, gp_Pnt(1.0, 0.0, 0.0));
    triangles->SetNode(3, gp_Pnt(0.0, 1.0, 0.1));
    triangles->SetTriangle(1, Poly_Triangle(1, 2, 3));
    TopoDS_Face face;
    BRep_Builder().MakeFace(face, triangles);
    return face;
}

/// Every type of curve and surface, seams, degenerate edges, locations in one another, mirrored and scaled shapes.
std::vector<TopoDS_Shape> shapes() {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(slanted(), 20.0, 8.0).Shape();
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(slanted(), 1.0, 2.0, 3.0).Shape();
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(1.0, 1.0, 0.0), gp_Dir(1.0, 0.3, 0.2)));
    gp_GTrsf stretched;
    stretched.SetValue(1, 1, 1.3);
    const gp_Elips ellipse(slanted(), 3.0, 1.7);
    const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(ellipse, 0.2, 2.4).Edge();
    return {
        box,
        torus,
        BRepPrimAPI_MakeSphere(slanted(), 4.0).Shape(),
        BRepPrimAPI_MakeCone(slanted(), 4.0, 0.0, 3.0).Shape(),
        BRepPrimAPI_MakeCylinder(slanted(), 1.5, 4.0, 2.0).Shape(),
        compound_of({torus.Moved(turned(0.7)), compound_of({torus, torus.Reversed()}).Moved(turned(1.1))})
            .Moved(turned(2.9)),
        box.Moved(turned(0.7).Inverted() * turned(0.2).Powered(3)),
        BRepBuilderAPI_Transform(torus, mirror, true).Shape(),
        BRepBuilderAPI_GTransform(torus, stretched, true).Shape(),
        swept(arc),
        swept(BRepBuilderAPI_MakeEdge(gp_Hypr(slanted(), 3.0, 1.7), -0.4, 0.9).Edge()),
        swept(BRepBuilderAPI_MakeEdge(gp_Parab(slanted(), 1.7), -0.4, 0.9).Edge()),
        BRepPrimAPI_MakeRevol(arc, gp_Ax1(gp_Pnt(9.0, 0.0, 0.0), gp_Dir(0.1, 1.0, 0.2)), 1.0).Shape(),
        face_of(saddle()),
        face_of(new Geom_OffsetSurface(saddle(), 0.3)),
        face_of(new Geom_RectangularTrimmedSurface(saddle(), 0.1, 0.9, 0.2, 0.7)),
        face_of_triangles(),
    };
}

TEST(ShapeStream, KeepsAllBits) {
    for (const TopoDS_Shape& shape : shapes()) {
        const std::string stream = write_shape_stream(shape);
        EXPECT_EQ(write_shape_stream(*read_shape_stream(stream)), stream) << "of " << stream.size() << " bytes";
    }
}

TEST(ShapeStream, KeepsBitsThatOpenCascadesReaderChanges) {
    const std::string stream = write_shape_stream(compound_of(shapes()));
    BinTools_ShapeSet set;
    std::istringstream in(stream);
    set.Read(in);
    int number = 0;
    BinTools::GetInteger(in, number);
    EXPECT_NE(write_shape_stream(set.Shape(number)), stream);
    EXPECT_EQ(write_shape_stream(*read_shape_stream(stream)), stream);
}

TEST(ShapeStream, KeepsWhatIsShared) {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20.0, 8.0).Shape();
    const auto read =
        read_shape_stream(write_shape_stream(compound_of({torus, torus.Moved(turned(0.7)), torus.Reversed()})));
    TopoDS_Iterator parts(*read, false, false);
    const TopoDS_Shape first = parts.Value();
    parts.Next();
    EXPECT_TRUE(first.IsPartner(parts.Value()));
    EXPECT_FALSE(first.IsSame(parts.Value()));
    parts.Next();
    EXPECT_TRUE(first.IsSame(parts.Value()));
    EXPECT_EQ(parts.Value().Orientation(), TopAbs_REVERSED);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(first, TopAbs_EDGE, edges);
    EXPECT_EQ(edges.Extent(), 2);  // both seams
}

TEST(ShapeStream, KeepsDegenerateEdgesValid) {
    EXPECT_TRUE(
        BRepCheck_Analyzer(*read_shape_stream(write_shape_stream(BRepPrimAPI_MakeSphere(4.0).Shape()))).IsValid());
}

TEST(ShapeStream, LeavesTriangulationsOut) {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20.0, 8.0).Shape();
    const std::string before = write_shape_stream(torus);
    BRepMesh_IncrementalMesh(torus, 0.1);
    EXPECT_EQ(write_shape_stream(torus).size(), before.size());
}

TEST(ShapeStream, RefusesWhatEndsEarly) {
    const std::string stream = write_shape_stream(compound_of(shapes()));
    const std::size_t step = stream.size() / 3000 + 1;
    for (std::size_t size = 0; size < stream.size(); size += step) {
        EXPECT_THROW(read_shape_stream(stream.substr(0, size)), InvalidInput) << size;
    }
    const std::string box = write_shape_stream(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape());
    for (std::size_t size = 0; size < box.size(); ++size) {
        EXPECT_THROW(read_shape_stream(box.substr(0, size)), InvalidInput) << size;
    }
}

TEST(ShapeStream, RefusesOrReadsWhatWasDamaged) {
    const std::string whole = write_shape_stream(compound_of(shapes()));
    std::mt19937 random(1);
    int refused = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string stream = whole;
        for (int k = 0; k < 1 + i % 3; ++k) {
            stream[random() % stream.size()] = static_cast<char>(random());
        }
        try {
            EXPECT_FALSE(read_shape_stream(stream)->IsNull());
        } catch (const InvalidInput&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 0);
}

TEST(ShapeStream, RefusesWhatIsNoShape) {
    for (const std::string& stream :
         {std::string(), std::string("\n"), std::string("\nOpen CASCADE Topology V1 (c)\n"),
          std::string("\nOpen CASCADE Topology V3 (c)\nLocations 99999\n"), write_shape_stream(TopoDS_Shape())}) {
        EXPECT_THROW(read_shape_stream(stream), InvalidInput);
    }
}

TEST(ShapeStream, KnowsShapesOfThisKernel) {
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex);
    EXPECT_TRUE(is_of_this_kernel(vertex));
}

}  // namespace
}  // namespace mq::geometry

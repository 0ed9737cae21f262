// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/stream/canonical_locations.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <array>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pnt2d.hxx>
#include <random>
#include <string>
#include <vector>

#include "geometry/assemblies.h"
#include "geometry/occt/stream/shape_stream.h"

namespace mq::geometry {
namespace {

/// As FreeCAD makes it of a placement.
gp_Trsf made_of_matrix(const gp_Trsf& motion) {
    gp_Trsf made;
    made.SetValues(motion.Value(1, 1), motion.Value(1, 2), motion.Value(1, 3), motion.Value(1, 4), motion.Value(2, 1),
                   motion.Value(2, 2), motion.Value(2, 3), motion.Value(2, 4), motion.Value(3, 1), motion.Value(3, 2),
                   motion.Value(3, 3), motion.Value(3, 4));
    return made;
}

/// Placements as FreeCAD makes them; their scale differs from 1 by rounding.
class Placements {
  public:
    gp_Trsf motion() {
        for (;;) {
            gp_Trsf turned;
            turned.SetRotation(gp_Ax1(gp_Pnt(number(), number(), number()), gp_Dir(number(), number(), 2.0)), number());
            const gp_Trsf made = made_of_matrix(turned);
            if (made.ScaleFactor() != 1.0) {
                return made;
            }
        }
    }
    TopLoc_Location operator()() { return TopLoc_Location(motion()); }

  private:
    double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
    std::mt19937 random_{1};
};

TopoDS_Shape located(const TopoDS_Shape& shape, const gp_Trsf& motion) {
    return shape.Located(TopLoc_Location(motion), false);
}

/// A box with a bore, of operands in placements: faces and edges have locations of their own.
TopoDS_Shape bored(Placements& placement) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-3.0, -2.0, -1.0), 6.0, 4.0, 2.0).Shape();
    const TopoDS_Shape tool =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0.0, 0.0, -9.0), gp_Dir(0.0, 0.0, 1.0)), 0.7, 18.0).Shape();
    return BRepAlgoAPI_Cut(box.Located(placement()), tool.Located(placement())).Shape();
}

/// A compound with locations at all depths.
TopoDS_Shape assembly() {
    Placements placement;
    const TopoDS_Shape cut = bored(placement);
    const TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(0.7, 9.0).Shape();
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(1.0, 1.0, 0.0), gp_Dir(1.0, 0.3, 0.2)));
    gp_Trsf twice;
    twice.SetScale(gp_Pnt(1.0, 0.0, 0.0), 2.0);
    const TopLoc_Location place = placement();
    const TopoDS_Shape inner =
        compound_of({cut.Located(placement()), cut.Located(place).Reversed(), tool.Located(place)});
    return compound_of({inner.Located(placement()), inner.Located(placement() * placement().Inverted()),
                        located(tool, made_of_matrix(placement.motion() * mirror)), located(tool, mirror),
                        located(inner, made_of_matrix(placement.motion() * twice))})
        .Located(placement());
}

using Numbers = std::array<double, 14>;

Numbers numbers_of(const TopLoc_Location& location) {
    const gp_Trsf& motion = location.Transformation();
    Numbers numbers = {motion.ScaleFactor(), static_cast<double>(motion.Form())};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            numbers[2 + 3 * i + j] = motion.HVectorialPart()(i + 1, j + 1);
        }
        numbers[11 + i] = motion.TranslationPart().Coord(i + 1);
    }
    return numbers;
}

Numbers numbers_of_geometry(const TopoDS_Shape& shape) {
    TopLoc_Location location;
    double first = 0.0;
    double last = 0.0;
    if (shape.ShapeType() == TopAbs_FACE) {
        BRep_Tool::Surface(TopoDS::Face(shape), location);
    } else if (shape.ShapeType() == TopAbs_EDGE) {
        BRep_Tool::Curve(TopoDS::Edge(shape), location, first, last);
    }
    return numbers_of(location);
}

TopTools_IndexedMapOfShape parts_of(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, parts);
    return parts;
}

TEST(CanonicalLocations, AreThoseThatAStreamGives) {
    const TopoDS_Shape shape = assembly();
    const TopTools_IndexedMapOfShape live = parts_of(*with_canonical_locations(shape));
    const TopTools_IndexedMapOfShape streamed = parts_of(*read_shape_stream(write_shape_stream(shape)));
    ASSERT_EQ(live.Extent(), streamed.Extent());
    ASSERT_GT(live.Extent(), 300);
    const TopTools_IndexedMapOfShape given = parts_of(shape);
    int differ = 0;
    for (int i = 1; i <= live.Extent(); ++i) {
        ASSERT_EQ(live(i).ShapeType(), streamed(i).ShapeType());
        EXPECT_EQ(live(i).Orientation(), streamed(i).Orientation());
        EXPECT_EQ(numbers_of(live(i).Location()), numbers_of(streamed(i).Location()));
        EXPECT_EQ(numbers_of_geometry(live(i)), numbers_of_geometry(streamed(i)));
        differ += numbers_of(given(i).Location()) != numbers_of(live(i).Location()) ? 1 : 0;
    }
    EXPECT_EQ(differ, live.Extent()) << "each is in a placement";
}

TEST(CanonicalLocations, KeepAllElse) {
    const TopoDS_Shape shape = assembly();
    const std::string before = write_shape_stream(shape);
    const auto canonical = with_canonical_locations(shape);
    EXPECT_TRUE(write_shape_stream(shape) == before) << "the shape itself has changed";
    EXPECT_EQ(write_shape_stream(*canonical).size(), before.size());
    const TopoDS_Shape rigid = TopoDS_Iterator(shape).Value();
    EXPECT_TRUE(write_shape_stream(*with_canonical_locations(rigid)) == write_shape_stream(rigid));
    const TopTools_IndexedMapOfShape given = parts_of(shape);
    const TopTools_IndexedMapOfShape parts = parts_of(*canonical);
    ASSERT_EQ(parts.Extent(), given.Extent()) << "the same at several places is no longer one";
    for (int i = 1; i <= parts.Extent(); ++i) {
        EXPECT_EQ(parts(i).Orientation(), given(i).Orientation());
        TopLoc_Location place;
        if (parts(i).ShapeType() == TopAbs_FACE) {
            EXPECT_EQ(BRep_Tool::Surface(TopoDS::Face(parts(i)), place),
                      BRep_Tool::Surface(TopoDS::Face(given(i)), place));
        } else if (parts(i).ShapeType() == TopAbs_VERTEX) {
            EXPECT_LT(BRep_Tool::Pnt(TopoDS::Vertex(parts(i))).Distance(BRep_Tool::Pnt(TopoDS::Vertex(given(i)))),
                      1e-13);
        }
    }
}

/// How many edges of faces have a curve there that is stored, and go smoothly into another face.
std::array<int, 2> stored_curves(const TopoDS_Shape& shape) {
    TopTools_IndexedDataMapOfShapeListOfShape faces_of_edges;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edges);
    std::array<int, 2> count{};
    for (int i = 1; i <= faces_of_edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(faces_of_edges.FindKey(i));
        for (const TopoDS_Shape& face : faces_of_edges(i)) {
            double first = 0.0;
            double last = 0.0;
            bool stored = false;
            BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face), first, last, &stored);
            count[0] += stored ? 1 : 0;
            count[1] += BRep_Tool::HasContinuity(edge, TopoDS::Face(face), TopoDS::Face(faces_of_edges(i).First()));
        }
    }
    return count;
}

TEST(CanonicalLocations, CurvesAndPointsAreStillFound) {
    Placements placement;
    const TopoDS_Shape cut = bored(placement);
    TopTools_IndexedDataMapOfShapeListOfShape faces_of_edges;
    TopExp::MapShapesAndAncestors(cut, TopAbs_EDGE, TopAbs_FACE, faces_of_edges);
    int rim = 1;  // a new edge, where both operands meet
    while (!faces_of_edges.FindKey(rim).Location().IsIdentity()) {
        ++rim;
    }
    const TopoDS_Edge& edge = TopoDS::Edge(faces_of_edges.FindKey(rim));
    const TopoDS_Face& face = TopoDS::Face(faces_of_edges(rim).First());
    const TopoDS_Face& other = TopoDS::Face(faces_of_edges(rim).Last());
    BRep_Builder builder;
    builder.Continuity(edge, face, other, GeomAbs_G1);
    TopoDS_Vertex inner;
    builder.MakeVertex(inner, gp_Pnt(0.0, 0.0, 0.0), 1e-3);
    builder.UpdateVertex(inner, 0.25, edge, 1e-3);
    builder.UpdateVertex(inner, 0.5, 0.75, face, 1e-3);
    const TopoDS_Shape shape = compound_of({cut, inner.Located(placement())});
    const auto canonical = with_canonical_locations(shape);
    const TopTools_IndexedMapOfShape given = parts_of(shape);
    const TopTools_IndexedMapOfShape parts = parts_of(*canonical);
    const auto found = [&](const TopoDS_Shape& part) { return parts(given.FindIndex(part)); };
    EXPECT_EQ(stored_curves(*canonical), stored_curves(shape));
    EXPECT_GT(stored_curves(*canonical)[0], 10);
    EXPECT_EQ(BRep_Tool::Continuity(TopoDS::Edge(found(edge)), TopoDS::Face(found(face)), TopoDS::Face(found(other))),
              GeomAbs_G1);
    const TopoDS_Vertex vertex = TopoDS::Vertex(parts(given.Extent()).Located(TopLoc_Location()));
    EXPECT_EQ(BRep_Tool::Parameter(vertex, TopoDS::Edge(found(edge))), 0.25);
    const gp_Pnt2d at = BRep_Tool::Parameters(vertex, TopoDS::Face(found(face)));
    EXPECT_EQ(at.X(), 0.5);
    EXPECT_EQ(at.Y(), 0.75);
}

TEST(CanonicalLocations, NothingIsCopiedWhereAllAre) {
    gp_Trsf shift;
    shift.SetTransformation(gp_Ax3(gp_Pnt(1.0, 2.0, 3.0), gp_Dir(1.0, 2.0, 3.0)), gp_Ax3());
    ASSERT_EQ(shift.ScaleFactor(), 1.0);
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    const TopoDS_Shape placed = compound_of({located(box, shift), box});
    EXPECT_TRUE(with_canonical_locations(placed)->IsEqual(placed));
    Placements placement;
    const auto moved = with_canonical_locations(compound_of({box.Located(placement()), box}));
    TopoDS_Iterator parts(*moved);
    EXPECT_EQ(parts.Value().Location().Transformation().ScaleFactor(), 1.0);
    EXPECT_TRUE(parts.Value().IsPartner(box)) << "a solid with no location inside is copied";
}

TEST(CanonicalLocations, AScaleThatIsNoneOfRoundingIsKept) {
    gp_Trsf twice;
    twice.SetScale(gp_Pnt(1.0, 2.0, 3.0), -2.0);
    const gp_Trsf canonical = canonical_transformation(twice.VectorialPart(), twice.TranslationPart());
    EXPECT_DOUBLE_EQ(canonical.ScaleFactor(), -2.0);
    const gp_Pnt there = gp_Pnt(0.3, 0.4, 0.5).Transformed(canonical);
    EXPECT_LT(there.Distance(gp_Pnt(0.3, 0.4, 0.5).Transformed(twice)), 1e-14);
    EXPECT_LT(there.Transformed(canonical.Inverted()).Distance(gp_Pnt(0.3, 0.4, 0.5)), 1e-14);
}

}  // namespace
}  // namespace mq::geometry

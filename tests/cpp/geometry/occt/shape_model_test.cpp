// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierSurface.hxx>
#include <Poly_Triangulation.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <sstream>

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/assemblies.h"
#include "geometry/parts.h"
#include "geometry/session.h"
#include "geometry/shapes.h"

namespace mq::geometry {
namespace {

TopoDS_Shape box123() {
    return BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
}

gp_Trsf turned_and_moved() {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1.0, 0.0, 2.0), gp_Dir(1.0, 2.0, -1.0)), 0.7);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(10.0, -3.0, 4.0));
    return move * turn;
}

gp_Trsf mirror() {
    gp_Trsf trsf;
    trsf.SetMirror(gp_Ax2(gp_Pnt(3.0, 1.0, 0.0), gp_Dir(1.0, 1.0, 0.3)));
    return trsf;
}

/// The same by a location on the shape, which OpenCASCADE accepts only with its check switched off.
TopoDS_Shape located(const TopoDS_Shape& shape, const gp_Trsf& trsf) {
    return shape.Located(TopLoc_Location(trsf), Standard_False);
}

TopoDS_Shape first_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    return TopExp_Explorer(shape, kind).Current();
}

std::string text_of(const TopoDS_Shape& shape) {
    std::ostringstream text;
    BRepTools::Write(shape, text);
    return text.str();
}

/// A step along the outward normal leaves the solid.
void expect_normals_outward(Model& model) {
    for (std::size_t i = 0; i < model.topology().faces.size(); ++i) {
        Vec3 point;
        const Vec3 normal = middle_normal(model, static_cast<int>(i), &point);
        EXPECT_EQ(model.answer(Query::volume_contains(0, point + 1e-3 * normal)).side, -1) << "face " << i;
        EXPECT_EQ(model.answer(Query::volume_contains(0, point - 1e-3 * normal)).side, 1) << "face " << i;
    }
}

TEST(ShapeModel, RefusesShapesWithoutFaces) {
    EXPECT_THROW(make_shape_model(TopoDS_Shape()), InvalidInput);
    const TopoDS_Shape edge = BRepBuilderAPI_MakeEdge(gp_Pnt(0.0, 0.0, 0.0), gp_Pnt(1.0, 0.0, 0.0)).Shape();
    try {
        make_shape_model(edge);
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("EDGE"), std::string::npos) << error.what();
    }
}

TEST(ShapeModel, NamesFacesWithoutSurface) {
    BRep_Builder builder;
    TopoDS_Face bare;
    builder.MakeFace(bare);
    try {
        make_shape_model(compound_of({box123(), bare}));
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string(error.what()).find("Face7"), std::string::npos) << error.what();
    }
}

TEST(ShapeModel, WalksFacesWithTheInteriorOnTheLeft) {
    for (const TopoDS_Shape& shape :
         {box123(), BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape(), BRepPrimAPI_MakeCone(2.0, 0.0, 5.0).Shape(),
          BRepPrimAPI_MakeSphere(2.0).Shape(), BRepPrimAPI_MakeTorus(5.0, 1.0).Shape()}) {
        for (const TopoDS_Shape& placed :
             {shape, shape.Reversed(), located(shape, mirror()), BRepBuilderAPI_Transform(shape, mirror()).Shape()}) {
            expect_uses_run_left(*make_shape_model(placed));
        }
    }
}

TEST(ShapeModel, HasOutwardNormalsWhereverTheShapeIsPut) {
    gp_Trsf shrink;
    shrink.SetScale(gp_Pnt(1.0, 2.0, 3.0), 0.5);
    gp_Trsf inversion;
    inversion.SetScale(gp_Pnt(1.0, 2.0, 3.0), -2.0);
    for (const TopoDS_Shape& shape :
         {box123(), BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape(), BRepPrimAPI_MakeCone(2.0, 1.0, 5.0).Shape(),
          BRepPrimAPI_MakeSphere(2.0).Shape(), BRepPrimAPI_MakeTorus(5.0, 1.0).Shape()}) {
        const double volume = flux_of_rectangles(*make_shape_model(shape));
        EXPECT_GT(volume, 0.0);
        for (const gp_Trsf& trsf : {gp_Trsf(), turned_and_moved(), mirror(), shrink, inversion}) {
            const double scale = std::abs(std::pow(trsf.ScaleFactor(), 3.0));
            const auto moved = make_shape_model(located(shape, trsf));
            EXPECT_NEAR(flux_of_rectangles(*moved), volume * scale, 0.02 * volume * scale);
            expect_normals_outward(*moved);
            const auto transformed = make_shape_model(BRepBuilderAPI_Transform(shape, trsf, Standard_True).Shape());
            EXPECT_NEAR(flux_of_rectangles(*transformed), volume * scale, 0.02 * volume * scale);
            expect_normals_outward(*transformed);
        }
    }
}

/// A location moves every answer: those of the shape at the origin, transformed.
TEST(ShapeModel, AnswersThroughLocations) {
    gp_Trsf grow;
    grow.SetScale(gp_Pnt(1.0, 2.0, 3.0), -2.0);
    const TopoDS_Shape shape = BRepPrimAPI_MakeCone(2.0, 1.0, 5.0).Shape();
    const auto plain = make_shape_model(shape);
    for (const gp_Trsf& trsf : {turned_and_moved(), mirror(), grow}) {
        const auto moved = make_shape_model(located(shape, trsf));
        const double scale = std::abs(trsf.ScaleFactor());
        const auto there = [&](const Vec3& p) {
            const gp_Pnt q = gp_Pnt(p.x(), p.y(), p.z()).Transformed(trsf);
            return Vec3(q.X(), q.Y(), q.Z());
        };
        const Topology& topology = plain->topology();
        for (int f = 0; f < static_cast<int>(topology.faces.size()); ++f) {
            const Answer a = plain->answer(Query::face_curvatures(f, 0.4, 0.7));
            const Answer b = moved->answer(Query::face_curvatures(f, 0.4, 0.7));
            EXPECT_LT((there(a.point) - b.point).norm(), 1e-9);
            EXPECT_NEAR(a.u / scale, b.u, 1e-9);
            const Vec3 outward = there(a.point + a.normal) - there(a.point);
            EXPECT_LT((outward.normalized() - b.normal).norm(), 1e-9);
            const Answer foot = moved->answer(Query::face_nearest(f, there(a.point + 0.2 * a.normal), 0.5, 0.6));
            EXPECT_NEAR(foot.u, 0.4, 1e-9);
            EXPECT_NEAR(foot.v, 0.7, 1e-9);
            EXPECT_NEAR(foot.distance, 0.2 * scale, 1e-9);
        }
        for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e) {
            const Edge& edge = topology.edges[static_cast<std::size_t>(e)];
            const Answer a = plain->answer(Query::edge_middle(e, edge.t0, edge.t1));
            const Answer b = moved->answer(Query::edge_middle(e, edge.t0, edge.t1));
            EXPECT_LT((there(a.point) - b.point).norm(), 1e-9);
            EXPECT_NEAR(moved->answer(Query::edge_length(e, edge.t0, edge.t1)).distance,
                        scale * plain->answer(Query::edge_length(e, edge.t0, edge.t1)).distance, 1e-9);
            const Answer c = moved->answer(Query::edge_at_distance(e, edge.t0, edge.t1, 0.5 * scale));
            EXPECT_NEAR(c.t, plain->answer(Query::edge_at_distance(e, edge.t0, edge.t1, 0.5)).t, 1e-9);
            EXPECT_NEAR(moved->answer(Query::edge_nearest(e, there(a.point), a.t + 0.1, edge.t0, edge.t1)).t, a.t,
                        1e-7);
        }
    }
}

TEST(ShapeModel, TurnsReversedShapesInsideOut) {
    const auto plain = make_shape_model(box123());
    const auto reversed = make_shape_model(box123().Reversed());
    for (int f = 0; f < 6; ++f) {
        EXPECT_LT((middle_normal(*plain, f) + middle_normal(*reversed, f)).norm(), 1e-12);
        EXPECT_NE(plain->topology().faces[static_cast<std::size_t>(f)].reversed,
                  reversed->topology().faces[static_cast<std::size_t>(f)].reversed);
    }
    EXPECT_TRUE(plain->topology().faults.empty());
    EXPECT_EQ(reversed->topology().faults, std::vector<std::string>{"Solid1: is turned inside out"});
    for (std::size_t i = 0; i < plain->topology().uses.size(); ++i) {
        EXPECT_EQ(plain->topology().uses[i].forward, reversed->topology().uses[i].forward);
    }
}

/// Two boxes side by side: the face between them is one, that one solid sees from its other side.
TEST(ShapeModel, SharesTheFaceBetweenTwoSolids) {
    BRepAlgoAPI_BuilderAlgo fuse;
    TopTools_ListOfShape arguments;
    arguments.Append(BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 0.0), gp_Pnt(1.0, 2.0, 3.0)).Shape());
    arguments.Append(BRepPrimAPI_MakeBox(gp_Pnt(1.0, 0.0, 0.0), gp_Pnt(2.0, 2.0, 3.0)).Shape());
    fuse.SetArguments(arguments);
    fuse.Build();
    const auto model = make_shape_model(fuse.Shape());
    const Topology& topology = model->topology();
    EXPECT_EQ(topology.faces.size(), 11u);
    ASSERT_EQ(topology.volumes.size(), 2u);
    std::vector<int> met(topology.faces.size(), 0);
    int flipped = 0;
    for (const Volume& volume : topology.volumes) {
        EXPECT_EQ(volume.kind, Volume::Kind::Solid);
        EXPECT_EQ(volume.sides.size(), 6u);
        for (const Volume::Side& side : volume.sides) {
            met[static_cast<std::size_t>(side.face)] += 1;
            flipped += side.flipped ? 1 : 0;
        }
    }
    EXPECT_EQ(std::count(met.begin(), met.end(), 2), 1);
    EXPECT_EQ(flipped, 1);
    for (int v = 0; v < 2; ++v) {
        for (const Volume::Side& side : topology.volumes[static_cast<std::size_t>(v)].sides) {
            Vec3 point;
            const Vec3 normal = (side.flipped ? -1.0 : 1.0) * middle_normal(*model, side.face, &point);
            EXPECT_EQ(model->answer(Query::volume_contains(v, point + 0.01 * normal)).side, -1);
            EXPECT_EQ(model->answer(Query::volume_contains(v, point - 0.01 * normal)).side, 1);
        }
    }
}

TEST(ShapeModel, GathersShellsAndLooseFaces) {
    BRep_Builder builder;
    TopoDS_Shell open;
    builder.MakeShell(open);
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(5.0, 0.0, 0.0), gp_Pnt(6.0, 1.0, 1.0)).Shape();
    int count = 0;
    for (TopExp_Explorer it(box, TopAbs_FACE); it.More() && count < 5; it.Next(), ++count) {
        builder.Add(open, it.Current());
    }
    const TopoDS_Shape loose =
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0.0, 0.0, 9.0), gp_Dir(0.0, 0.0, 1.0)), -1.0, 1.0, -2.0, 2.0).Shape();
    const auto model = make_shape_model(compound_of({loose, open, box123()}));
    const Topology& topology = model->topology();
    ASSERT_EQ(topology.volumes.size(), 3u);
    EXPECT_EQ(topology.volumes[0].kind, Volume::Kind::Solid);
    EXPECT_EQ(topology.volumes[1].kind, Volume::Kind::Shell);
    EXPECT_EQ(topology.volumes[1].sides.size(), 5u);
    EXPECT_EQ(topology.volumes[2].kind, Volume::Kind::Faces);
    ASSERT_EQ(topology.volumes[2].sides.size(), 1u);
    EXPECT_EQ(topology.volumes[2].sides[0].face, 0);
    EXPECT_EQ(model->answer(Query::volume_contains(2, Vec3::Zero())).status, Status::BadQuery);
    int once = 0;
    for (const Edge& edge : topology.edges) {
        once += edge.uses.size() == 1 ? 1 : 0;
    }
    EXPECT_EQ(once, 8);
}

TEST(ShapeModel, CountsASolidMetTwiceOnce) {
    const TopoDS_Shape box = box123();
    EXPECT_EQ(make_shape_model(compound_of({box, box}))->topology().volumes.size(), 1u);
    EXPECT_EQ(make_shape_model(compound_of({box, located(box, turned_and_moved())}))->topology().volumes.size(), 2u);
}

std::vector<TopoDS_Shape> listed(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    std::vector<TopoDS_Shape> result;
    for (TopExp_Explorer it(shape, kind); it.More(); it.Next()) {
        result.push_back(it.Current());
    }
    return result;
}

/// A compound as in BREP files of Gmsh: solids, and beside them their shells, faces, edges and vertices again.
TEST(ShapeModel, MeetsWhatIsListedAgainBesideItsSolidOnce) {
    const TopoDS_Shape box = box123();
    const TopoDS_Shape other = located(box, turned_and_moved());
    BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
        for (const TopoDS_Shape& solid : {box, other}) {
            for (const TopoDS_Shape& one : listed(solid, kind)) {
                builder.Add(all, one);
            }
        }
    }
    const auto model = make_shape_model(all);
    ASSERT_EQ(model->topology().volumes.size(), 2u);
    EXPECT_EQ(model->topology().faces.size(), 12u);
    for (const Volume& volume : model->topology().volumes) {
        EXPECT_EQ(volume.kind, Volume::Kind::Solid);
        EXPECT_EQ(volume.sides.size(), 6u);
    }
}

TEST(ShapeModel, MeetsTheShellOfASolidOnceHoweverItIsListed) {
    const TopoDS_Shape box = box123();
    const TopoDS_Shape shell = first_of(box, TopAbs_SHELL);
    BRep_Builder builder;
    TopoDS_Shell copied;  // another shell of the same faces
    builder.MakeShell(copied);
    for (const TopoDS_Shape& face : listed(box, TopAbs_FACE)) {
        builder.Add(copied, face);
    }
    const TopoDS_Shape solid_again = BRepBuilderAPI_MakeSolid(copied).Shape();
    for (const TopoDS_Shape& again : std::vector<TopoDS_Shape>{shell, shell.Reversed(), copied, solid_again}) {
        EXPECT_EQ(make_shape_model(compound_of({again, box}))->topology().volumes.size(), 1u);
        EXPECT_EQ(make_shape_model(compound_of({box, again}))->topology().volumes.size(), 1u);
    }
}

TEST(ShapeModel, KeepsShellsThatTouchInAFaceWhole) {
    BRepAlgoAPI_BuilderAlgo fuse;
    TopTools_ListOfShape arguments;
    arguments.Append(BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 0.0), gp_Pnt(1.0, 2.0, 3.0)).Shape());
    arguments.Append(BRepPrimAPI_MakeBox(gp_Pnt(1.0, 0.0, 0.0), gp_Pnt(2.0, 2.0, 3.0)).Shape());
    fuse.SetArguments(arguments);
    fuse.Build();
    const std::vector<TopoDS_Shape> shells = listed(fuse.Shape(), TopAbs_SHELL);
    ASSERT_EQ(shells.size(), 2u);
    const auto model = make_shape_model(compound_of({shells[0], shells[1]}));
    ASSERT_EQ(model->topology().volumes.size(), 2u);
    EXPECT_EQ(model->topology().volumes[0].sides.size(), 6u);
    EXPECT_EQ(model->topology().volumes[1].sides.size(), 6u);
}

TEST(ShapeModel, MarksEdgesInsideAFace) {
    BRep_Builder builder;
    TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), -2.0, 2.0, -2.0, 2.0).Face();
    TopoDS_Wire slit;
    builder.MakeWire(slit);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Pnt(-1.0, 0.0, 0.0), gp_Pnt(1.0, 0.0, 0.0)).Edge();
    builder.Add(slit, edge.Oriented(TopAbs_INTERNAL));
    builder.Add(face, slit);
    const auto model = make_shape_model(face);
    const Topology& topology = model->topology();
    ASSERT_EQ(topology.uses.size(), 5u);
    int internal = 0;
    for (const EdgeUse& use : topology.uses) {
        internal += use.internal ? 1 : 0;
    }
    EXPECT_EQ(internal, 1);
    EXPECT_EQ(topology.faces[0].loops.size(), 2u);
    EXPECT_LT(model->answer(Query::use_on_face(4, 1.0)).point.norm(), 1e-9);
}

TEST(ShapeModel, NamesMissingCurvesAndAnswersWithoutThem) {
    BRep_Builder builder;
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape();
    TopoDS_Face face =
        BRepBuilderAPI_MakeFace(BRep_Tool::Surface(TopoDS::Face(first_of(cylinder, TopAbs_FACE))), 1e-7).Face();
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    builder.Add(wire, BRepBuilderAPI_MakeEdge(gp_Pnt(2.0, 0.0, 1.0), gp_Pnt(2.0, 0.0, 3.0)).Edge());
    face = TopoDS::Face(face.EmptyCopied());
    builder.Add(face, wire);
    const auto model = make_shape_model(face);
    const auto& faults = model->topology().faults;
    EXPECT_NE(std::find(faults.begin(), faults.end(), "Edge1: has no curve on Face1"), faults.end());
    const Answer answer = model->answer(Query::use_on_face(0, 1.0));
    EXPECT_TRUE(answer.found());
    EXPECT_LT((answer.point - Vec3(2.0, 0.0, 2.0)).norm(), 1e-9);
}

TEST(ShapeModel, NamesWhatTheKernelFinds) {
    // A bow tie.
    BRep_Builder builder;
    TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), -1.0, 1.0, -1.0, 1.0).Face();
    face = TopoDS::Face(face.EmptyCopied());
    const gp_Pnt corners[] = {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    TopoDS_Vertex vertices[4];
    for (int i = 0; i < 4; ++i) {
        builder.MakeVertex(vertices[i], corners[i], 1e-7);
    }
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (int i = 0; i < 4; ++i) {
        builder.Add(wire, BRepBuilderAPI_MakeEdge(vertices[i], vertices[(i + 1) % 4]).Edge());
    }
    builder.Add(face, wire);
    const auto model = make_shape_model(face);
    bool named = false;
    for (const std::string& fault : model->topology().faults) {
        named = named || fault.find("self-intersecting wire") != std::string::npos;
    }
    EXPECT_TRUE(named);
}

/// The first two rows of poles coincide: Su vanishes all along u = 0.
TopoDS_Face patch_of(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c, const gp_Pnt& d) {
    TColgp_Array2OfPnt poles(1, 3, 1, 3);
    const gp_Pnt rows[3][2] = {{a, b}, {a, b}, {c, d}};
    for (int i = 0; i < 3; ++i) {
        poles(i + 1, 1) = rows[i][0];
        poles(i + 1, 2) = gp_Pnt(0.5 * (rows[i][0].XYZ() + rows[i][1].XYZ()));
        poles(i + 1, 3) = rows[i][1];
    }
    return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face();
}

TEST(ShapeModel, NamesFacesWithoutArea) {
    const gp_Pnt a(0.0, 0.0, 0.0);
    const gp_Pnt b(4.0, 0.0, 0.0);
    const auto model = make_shape_model(compound_of({box123(), patch_of(a, b, a, b)}));
    const auto& faults = model->topology().faults;
    EXPECT_NE(std::find(faults.begin(), faults.end(), "Face7: has no area"), faults.end());
}

/// In a shape of a thousandth of a millimetre narrow faces still have an area.
TEST(ShapeModel, KeepsNarrowFacesOfSmallParts) {
    for (const double length : {1.0, 1e-4}) {
        const TopoDS_Face narrow = patch_of({0.0, 0.0, 0.0}, {length, 0.0, 0.0}, {0.0, 4e-8, 0.0}, {length, 4e-8, 0.0});
        const bool left_out = make_shape_model(narrow)->topology().faces[0].no_area;
        EXPECT_EQ(left_out, length == 1.0) << length;
    }
}

/// Su vanishes on the whole border, which is no pole: the normal is the limit from inside, point by point.
TEST(ShapeModel, HasNormalsWhereADerivativeVanishes) {
    const auto model = make_shape_model(patch_of({0.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, {2.0, 0.0, 1.0}, {2.0, 4.0, 3.0}));
    for (const double v : {0.0, 0.3, 1.0}) {
        const Answer answer = model->answer(Query::face_point(0, 0.0, v));
        ASSERT_EQ(answer.status, Status::Ok) << v;
        const Vec3 expected = Vec3(2.0, 0.0, 1.0 + 2.0 * v).cross(Vec3::UnitY()).normalized();
        EXPECT_LT((answer.normal - expected).norm(), 1e-4) << v;
        const Answer foot = model->answer(Query::face_nearest(0, Vec3(0.5, 1.0, 0.3), 0.0, v));
        EXPECT_NEAR(foot.distance, model->answer(Query::face_nearest_global(0, Vec3(0.5, 1.0, 0.3))).distance, 1e-9);
        EXPECT_GT(foot.u, 0.1);
    }
}

TEST(ShapeModel, LeavesTheShapeAndItsDisplayAlone) {
    const TopoDS_Shape shape = compound_of({BRepPrimAPI_MakeCone(2.0, 0.0, 5.0).Shape(), box123()});
    BRepMesh_IncrementalMesh(shape, 0.1);
    std::vector<std::pair<const Poly_Triangulation*, int>> before;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
        TopLoc_Location location;
        const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location);
        before.emplace_back(mesh.get(), mesh->NbNodes());
    }
    const std::string text = text_of(shape);
    const auto model = make_shape_model(shape);
    for (int f = 0; f < static_cast<int>(before.size()); ++f) {
        model->answer(Query::face_nearest_global(f, Vec3(1.0, 1.0, 1.0)));
        model->answer(Query::face_contains(f, 0.5, 0.5));
        middle_normal(*model, f);
    }
    model->answer(Query::volume_contains(0, Vec3(0.1, 0.1, 0.1)));
    for (int u = 0; u < static_cast<int>(model->topology().uses.size()); ++u) {
        model->answer(Query::use_on_face(u, 0.5));
    }
    EXPECT_EQ(text_of(shape), text);
    std::size_t i = 0;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next(), ++i) {
        TopLoc_Location location;
        const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location);
        EXPECT_EQ(mesh.get(), before[i].first);
        EXPECT_EQ(mesh->NbNodes(), before[i].second);
    }
}

/// A coarse display triangulation must not decide how large the shape is.
TEST(ShapeModel, BoundsThePartAndNotItsDisplay) {
    const TopoDS_Shape shape = BRepPrimAPI_MakeSphere(10.0).Shape();
    const Box before = make_shape_model(shape)->topology().box;
    BRepMesh_IncrementalMesh(shape, 5.0);
    const Box after = make_shape_model(shape)->topology().box;
    EXPECT_EQ(before.low, after.low);
    EXPECT_EQ(before.high, after.high);
    EXPECT_NEAR(before.largest_side(), 20.0, 1e-3);
    EXPECT_GE(before.largest_side(), 20.0);
}

/// Several threads answer for one shape, each with evaluators of its own.
TEST(ShapeModel, AnswersInSeveralThreadsAreThoseOfOne) {
    Engine engine;
    std::shared_ptr<Model> model;
    engine.run([&] { model = make_shape_model(stored("blade")); });
    std::vector<Query> queries;
    for (int face = 0; face < static_cast<int>(model->topology().faces.size()); ++face) {
        for (int k = 0; k < 100; ++k) {
            queries.push_back(Query::face_nearest_global(face, Vec3(0.04 * k, 0.37 * (k % 7), 0.21 * (k % 5))));
        }
    }
    ASSERT_GT(queries.size(), Session::kChunk);
    const Engine::Answers one = engine.ask(model, queries);
    Session session(engine, model);
    for (const int threads : {1, 2, 3}) {
        const ThreadLimit limit(threads);
        Engine::Answers several(queries.size());
        std::vector<Answerer*> by(queries.size(), nullptr);
        session.run_parallel(static_cast<int>(queries.size()), [&](Answerer& answerer, int k) {
            several[static_cast<std::size_t>(k)] = answerer.answer(queries[static_cast<std::size_t>(k)]);
            by[static_cast<std::size_t>(k)] = &answerer;
        });
        for (std::size_t i = 0; i < queries.size(); ++i) {
            EXPECT_EQ(several[i].status, one[i].status);
            EXPECT_EQ(several[i].point, one[i].point);
            EXPECT_EQ(several[i].normal, one[i].normal);
            EXPECT_EQ(several[i].u, one[i].u);
        }
        const Engine::Answers asked = session.ask(queries);
        ASSERT_EQ(asked.size(), one.size());
        for (std::size_t i = 0; i < queries.size(); ++i) {
            EXPECT_EQ(asked[i].point, one[i].point);
            EXPECT_EQ(asked[i].distance, one[i].distance);
        }
        std::sort(by.begin(), by.end());
        EXPECT_LE(std::unique(by.begin(), by.end()) - by.begin(), threads);
    }
    EXPECT_THROW(session.run_parallel(8,
                                      [](Answerer&, int k) {
                                          if (k == 3) {
                                              throw Cancelled(Message::value("here"));
                                          }
                                      }),
                 Cancelled);
}

}  // namespace
}  // namespace mq::geometry

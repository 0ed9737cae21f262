// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/loose_faces.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>

#include "geometry/parts.h"

namespace mq::geometry {
namespace {

constexpr double kDetail = 1e-3;

/// The faces of a shape without common edges, each moved by its number times this along x, every third one turned.
TopoDS_Compound loose(const TopoDS_Shape& shape, double apart = 0.0) {
    BRep_Builder builder;
    TopoDS_Compound result;
    builder.MakeCompound(result);
    int i = 0;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next(), ++i) {
        const TopoDS_Shape copy = moved_to(BRepBuilderAPI_Copy(it.Current()).Shape(), i * apart, 0.0, 0.0);
        builder.Add(result, i % 3 == 0 ? copy.Reversed() : copy);
    }
    return result;
}

std::shared_ptr<Model> model_of(const TopoDS_Shape& shape, double detail = kDetail) {
    return make_shape_model(shape, nullptr, Creases::Keep, {[detail](const Box&) { return detail; }});
}

int count_edges(const Topology& topology, std::size_t uses) {
    int count = 0;
    for (const Edge& edge : topology.edges) {
        count += !edge.degenerate && edge.uses.size() == uses ? 1 : 0;
    }
    return count;
}

/// Whether the faces beside each edge run along it in opposite directions, seen from outside.
bool oriented(const Topology& topology) {
    for (const Edge& edge : topology.edges) {
        if (edge.uses.size() == 2) {
            const auto runs = [&](int u) {
                const EdgeUse& use = topology.uses[static_cast<std::size_t>(u)];
                return use.forward != topology.faces[static_cast<std::size_t>(use.face)].reversed;
            };
            if (runs(edge.uses[0]) == runs(edge.uses[1])) {
                return false;
            }
        }
    }
    return true;
}

TEST(LooseFaces, OfABoxAreJoinedAndShowOneSide) {
    const auto model = model_of(loose(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()));
    EXPECT_EQ(count_edges(model->topology(), 2), 12);
    EXPECT_EQ(count_edges(model->topology(), 1), 0);
    EXPECT_TRUE(oriented(model->topology()));
    ASSERT_EQ(model->topology().faults.size(), 1u);
    EXPECT_EQ(model->topology().faults[0].rfind("edges of loose faces were joined in 12 pairs", 0), 0u);
}

TEST(LooseFaces, OfACylinderAreJoinedAlongItsCircles) {
    const auto model = model_of(loose(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape()));
    EXPECT_EQ(count_edges(model->topology(), 1), 0);
    EXPECT_TRUE(oriented(model->topology()));
}

TEST(LooseFaces, FartherApartThanTheDetailStayLoose) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    EXPECT_EQ(count_edges(model_of(loose(box, 0.1 * kDetail))->topology(), 2), 12);
    EXPECT_EQ(count_edges(model_of(loose(box, 20.0 * kDetail))->topology(), 2), 0);
    EXPECT_EQ(count_edges(model_of(loose(box), 0.0)->topology(), 2), 0);
}

/// A square beside two that share its side: the pieces are named after the whole edge, and its curve on the face goes
/// with them.
TEST(LooseFaces, EdgesAreDividedWhereTheirNeighboursEnd) {
    const auto rectangle = [](double x0, double x1, double y0, double y1) {
        return planar_face({line(x0, y0, x1, y0), line(x1, y0, x1, y1), line(x1, y1, x0, y1), line(x0, y1, x0, y0)});
    };
    BRep_Builder builder;
    TopoDS_Compound faces;
    builder.MakeCompound(faces);
    builder.Add(faces, rectangle(0.0, 1.0, 0.0, 1.0));
    builder.Add(faces, rectangle(1.0, 2.0, -0.5, 0.3));
    builder.Add(faces, rectangle(1.0, 2.0, 0.3, 1.2).Reversed());
    const auto model = model_of(faces);
    const Topology& topology = model->topology();
    EXPECT_EQ(count_edges(topology, 2), 3);  // two pieces of the side, and the edge between the two squares beside it
    EXPECT_TRUE(oriented(topology));
    const std::size_t own = topology.own_count(1);
    EXPECT_EQ(own, 12u);
    EXPECT_EQ(topology.edges.size(), own + 3);  // the side at 0.3, its neighbours at its ends
    for (const Edge& edge : topology.edges) {
        for (const int use : edge.uses) {
            const Answer on_edge =
                model->answer(Query::edge_point(topology.uses[static_cast<std::size_t>(use)].edge, edge.t0));
            const Answer on_face = model->answer(Query::use_on_face(use, edge.t0));
            ASSERT_TRUE(on_edge.found() && on_face.found());
            EXPECT_LT((on_edge.point - on_face.point).norm(), 1e-9);
        }
    }
    for (std::size_t e = own; e < topology.edges.size(); ++e) {
        EXPECT_LT(static_cast<std::size_t>(topology.of_shape({1, static_cast<int>(e)}).index), own);
    }
}

/// Whether the outward normal in the middle of a face points away from this point.
bool looks_away(Model& model, int face, const Vec3& point) {
    const Face& data = model.topology().faces[static_cast<std::size_t>(face)];
    const Answer middle =
        model.answer(Query::face_point(face, 0.5 * (data.low[0] + data.high[0]), 0.5 * (data.low[1] + data.high[1])));
    EXPECT_TRUE(middle.found());
    return (middle.point - point).dot(middle.normal) > 0.0;
}

TEST(LooseFaces, OfClosedSetsShowTheirOutsideAndVoidsTheirInside) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 0.0), 1.0, 2.0, 3.0).Shape();
    const gp_Ax2 at(gp_Pnt(0.5, 1.0, 0.5), gp_Dir(0.0, 0.0, 1.0));
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(at, 0.4, 0.0, 1.2).Shape();
    const TopoDS_Shape inverted_cone = BRepPrimAPI_MakeCone(at, 0.0, 0.4, 1.2).Shape();
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(0.2, 0.2, 0.2), 0.5, 0.5, 0.5).Shape();
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(0.5, 1.0, 1.5), gp_Dir(1.0, 0.0, 0.0)));
    for (const TopoDS_Shape& inner : {block, cone, inverted_cone}) {
        for (const bool in_mirror : {false, true}) {
            SCOPED_TRACE(in_mirror);
            BRep_Builder builder;
            TopoDS_Compound both;
            builder.MakeCompound(both);
            for (const TopoDS_Shape& part : {box, inner}) {
                for (TopExp_Explorer it(part, TopAbs_FACE); it.More(); it.Next()) {
                    const TopoDS_Shape face = BRepBuilderAPI_Copy(it.Current()).Shape().Reversed();
                    builder.Add(both, in_mirror ? face.Located(TopLoc_Location(mirror), Standard_False) : face);
                }
            }
            const auto model = model_of(both);
            const Vec3 centre(in_mirror ? 0.55 : 0.45, inner.IsSame(block) ? 0.45 : 1.0,
                              inner.IsSame(block) ? 0.45 : 1.1);
            const int faces = static_cast<int>(model->topology().faces.size());
            for (int f = 0; f < faces; ++f) {
                EXPECT_EQ(looks_away(*model, f, f < 6 ? Vec3(0.5, 1.0, 1.5) : centre), f < 6) << f;
            }
        }
    }
}

TEST(LooseFaces, ThatLieOnEachOtherAreNotJoined) {
    const TopoDS_Face face =
        planar_face({line(0.0, 0.0, 1.0, 0.0), line(1.0, 0.0, 0.0, 1.0), line(0.0, 1.0, 0.0, 0.0)});
    BRep_Builder builder;
    TopoDS_Compound twice;
    builder.MakeCompound(twice);
    builder.Add(twice, face);
    builder.Add(twice, BRepBuilderAPI_Copy(face).Shape());
    EXPECT_EQ(count_edges(model_of(twice)->topology(), 2), 0);
}

TEST(LooseFaces, FacesOfShellsAreLeftAlone) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    BRep_Builder builder;
    TopoDS_Compound two;
    builder.MakeCompound(two);
    builder.Add(two, shell_of(box, 3));
    builder.Add(two, shell_of(BRepBuilderAPI_Copy(box).Shape(), 5));
    const int before = count_edges(make_shape_model(two)->topology(), 2);
    EXPECT_EQ(count_edges(model_of(two)->topology(), 2), before);
}

}  // namespace
}  // namespace mq::geometry

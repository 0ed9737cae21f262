// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/loose_faces.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
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

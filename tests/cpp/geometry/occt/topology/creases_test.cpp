// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <set>

#include "geometry/creased_shapes.h"
#include "geometry/shapes.h"

namespace mq::geometry {
namespace {

std::shared_ptr<Model> cut(const TopoDS_Shape& shape) {
    return make_shape_model(shape, nullptr, Creases::Cut);
}

TEST(Creases, BecomeEdgesOfPieces) {
    const TopoDS_Shape block = block_with_one_side();
    ASSERT_EQ(make_shape_model(block)->topology().faces.size(), 3u);
    const auto model = cut(block);
    const Topology& topology = model->topology();
    EXPECT_TRUE(topology.faults.empty()) << topology.faults.front();
    EXPECT_EQ(topology.faces.size(), 6u);
    EXPECT_EQ(topology.own_count(2), 3u);
    EXPECT_EQ(topology.own_count(1), 3u);
    EXPECT_EQ(topology.own_count(0), 2u);
    std::size_t used = 0;
    for (const Edge& edge : topology.edges) {
        used += edge.uses.empty() ? 0 : 1;
        EXPECT_TRUE(edge.uses.empty() || edge.uses.size() == 2);
    }
    EXPECT_EQ(used, 12u);
    expect_uses_run_left(*model);
    EXPECT_NEAR(flux_of_rectangles(*model), 24.0, 1e-9);
}

TEST(Creases, AreKnownByTheWhole) {
    const auto model = cut(block_with_one_side());
    const Topology& topology = model->topology();
    std::set<std::string> names;
    for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e) {
        names.insert(topology.name_of({1, e}));
    }
    EXPECT_EQ(names, (std::set<std::string>{"Edge1", "Edge2", "Edge3", "a crease of Face1"}));
    for (int f = 0; f < static_cast<int>(topology.faces.size()); ++f) {
        const Entity whole = topology.of_shape({2, f});
        EXPECT_EQ(whole.dimension, 2);
        EXPECT_LT(whole.index, 3);
        EXPECT_EQ(topology.name_of({2, f}), name_of(whole));
    }
    EXPECT_EQ(topology.pieces_of({2, 0}).size(), 4u);
    EXPECT_EQ(topology.pieces_of({2, 1}), std::vector<int>{1});
    EXPECT_EQ(topology.name_of({0, 2}).rfind("the end of a crease on Edge", 0), 0u);
}

TEST(Creases, FollowTheShapesPlace) {
    const TopoDS_Shape block = block_with_one_side();
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1.0, 0.0, 2.0), gp_Dir(1.0, 2.0, -1.0)), 0.7);
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(3.0, 1.0, 0.0), gp_Dir(1.0, 1.0, 0.3)));
    const auto here = cut(block);
    for (const gp_Trsf& trsf : {turn, mirror}) {
        const auto there = cut(block.Located(TopLoc_Location(trsf), Standard_False));
        const Topology& topology = there->topology();
        ASSERT_EQ(topology.nodes.size(), here->topology().nodes.size());
        for (std::size_t i = 0; i < topology.nodes.size(); ++i) {
            const Vec3& p = here->topology().nodes[i].point;
            const gp_Pnt moved = gp_Pnt(p.x(), p.y(), p.z()).Transformed(trsf);
            EXPECT_LT((topology.nodes[i].point - Vec3(moved.X(), moved.Y(), moved.Z())).norm(), 1e-12);
        }
        EXPECT_TRUE(topology.faults.empty());
        EXPECT_NEAR(flux_of_rectangles(*there), 24.0, 1e-9);
    }
    // The geometry of a face does not depend on its placement.
    const auto there = cut(block.Located(TopLoc_Location(turn)));
    for (int f = 0; f < static_cast<int>(here->topology().faces.size()); ++f) {
        Fingerprint one{};
        Fingerprint other{};
        here->add_definition({2, f}, -1, one);
        there->add_definition({2, f}, -1, other);
        EXPECT_EQ(one, other) << "face " << f;
    }
}

TEST(Creases, PiecesWithoutAreaAreSewnUp) {
    const auto model = cut(wing_with_flat_ends());
    const Topology& topology = model->topology();
    EXPECT_TRUE(topology.faults.empty()) << topology.faults.front();
    EXPECT_EQ(topology.own_count(2), 1u);
    std::size_t empty = 0;
    for (const Face& face : topology.faces) {
        empty += face.no_area ? 1 : 0;
        EXPECT_EQ(face.no_area, face.loops.empty());
    }
    EXPECT_EQ(empty, 4u);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const std::size_t uses = topology.edges[e].uses.size();
        EXPECT_TRUE(uses == 0 || uses == 2) << "edge " << e << " has " << uses;
    }
}

TEST(Creases, SmoothPartsStayAsTheyAre) {
    for (const TopoDS_Shape& shape :
         {BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(), BRepPrimAPI_MakeSphere(2.0).Shape(),
          BRepPrimAPI_MakeCone(1.0, 0.0, 3.0).Shape(), BRepPrimAPI_MakeTorus(5.0, 1.0).Shape()}) {
        const auto whole = make_shape_model(shape);
        const auto same = cut(shape);
        EXPECT_EQ(same->topology().faces.size(), whole->topology().faces.size());
        EXPECT_EQ(same->topology().edges.size(), whole->topology().edges.size());
        EXPECT_EQ(same->topology().own_count(2), whole->topology().faces.size());
    }
}

/// OpenCASCADE confuses the seams of surfaces that are closed in both directions where it cuts them elsewhere.
TEST(Creases, OneFaceThatCannotBeCutDoesNotKeepTheOthersFromIt) {
    const TopoDS_Shape ring = ring_with_one_side();
    const auto alone = cut(ring);
    EXPECT_EQ(alone->topology().faces.size(), 1u);
    ASSERT_EQ(alone->topology().faults.size(), 1u);
    EXPECT_EQ(alone->topology().faults.front(),
              "creases inside faces are not followed: OpenCASCADE cannot cut along them (Face1)");

    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, ring);
    builder.Add(both, block_with_one_side());
    const auto model = cut(both);
    EXPECT_EQ(model->topology().pieces_of({2, 0}).size(), 1u);
    EXPECT_EQ(model->topology().pieces_of({2, 1}).size(), 4u);
    EXPECT_EQ(model->topology().faults, alone->topology().faults);
    expect_uses_run_left(*model);
}

}  // namespace
}  // namespace mq::geometry

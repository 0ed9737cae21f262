// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/matching.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>

#include "base/error.h"
#include "geometry/occt/shape_model.h"
#include "geometry/parts.h"
#include "given/simplices/given.h"

namespace mq::given {

using curve::curved;
using curve::of_order;

namespace {

MatchedMesh matched(const std::shared_ptr<geometry::Model>& model, const GivenMesh& mesh) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    geometry::Session session(engine, model);
    return match(session, mesh, 2);
}

std::string refusal(const std::shared_ptr<geometry::Model>& model, const GivenMesh& mesh) {
    try {
        matched(model, mesh);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Matching, FindsTheEntitiesThatTheMeshWasMadeOn) {
    for (const geometry::Part& part : geometry::shape_parts()) {
        const curve::CurvedMesh mesh = curved(part.model, of_order(1));
        const MatchedMesh found = matched(part.model, given_of(mesh));
        ASSERT_EQ(found.surface.triangles.size(), mesh.triangle_face.size()) << part.name;
        for (std::size_t t = 0; t < mesh.triangle_face.size(); ++t) {
            ASSERT_EQ(found.surface.triangles[t].face, mesh.triangle_face[t]) << part.name << ", triangle " << t;
        }
        for (std::size_t v = 0; v < mesh.vertices; ++v) {
            const int vertex = found.vertex_of_node[v];
            ASSERT_GE(vertex, 0) << part.name;
            ASSERT_EQ(found.surface.shapes.vertices[static_cast<std::size_t>(vertex)].entity, mesh.node_entity[v])
                << part.name << ", vertex " << v;
        }
        EXPECT_TRUE(found.moved.empty()) << part.name;
    }
}

TEST(Matching, KeepsNodesToTheLastBit) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape());
    const GivenMesh mesh = given_of(curved(model, of_order(1)));
    const MatchedMesh found = matched(model, mesh);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const auto vertex = static_cast<std::size_t>(found.vertex_of_node[n]);
        EXPECT_EQ(found.surface.shapes.vertices[vertex].point, mesh.nodes[n]);
    }
}

TEST(Matching, NodesBesideTheCadAreMovedAndListed) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape());
    GivenMesh mesh = given_of(curved(model, of_order(1)));
    const std::size_t last = mesh.nodes.size() - 1;
    mesh.nodes[last] *= 1.001;
    const MatchedMesh found = matched(model, mesh);
    ASSERT_EQ(found.moved.size(), 1u);
    EXPECT_EQ(found.moved[0].node, static_cast<int>(last));
    EXPECT_NEAR(found.moved[0].distance, 0.001, 1e-6);
    mesh.nodes[last] *= 1.1;
    EXPECT_NE(refusal(model, mesh).find("mm off Face1"), std::string::npos) << refusal(model, mesh);
}

TEST(Matching, BodiesThatTouchAreToldApart) {
    // Two boxes with a common corner edge, each with vertices of its own there.
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape());
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 0), 1.0, 1.0, 1.0).Shape());
    const auto model = geometry::make_shape_model(both);
    const curve::CurvedMesh mesh = curved(model, of_order(1));
    const MatchedMesh found = matched(model, given_of(mesh));
    for (std::size_t t = 0; t < mesh.triangle_face.size(); ++t) {
        EXPECT_EQ(found.surface.triangles[t].face, mesh.triangle_face[t]);
    }
}

TEST(Matching, OtherUnitsAndPlacesAreSaid) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeBox(30.0, 20.0, 10.0).Shape());
    const GivenMesh mesh = given_of(curved(model, of_order(1)));
    GivenMesh metres = mesh;
    GivenMesh elsewhere = mesh;
    GivenMesh inches = mesh;
    GivenMesh larger = mesh;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        metres.nodes[n] *= 1e-3;
        inches.nodes[n] /= 25.4;
        larger.nodes[n] *= 25.4;
        elsewhere.nodes[n] += Vec3(100, 0, 0);
    }
    EXPECT_NE(refusal(model, metres).find("scale=1000"), std::string::npos) << refusal(model, metres);
    EXPECT_NE(refusal(model, inches).find("scale=25.4"), std::string::npos) << refusal(model, inches);
    EXPECT_NE(refusal(model, larger)
                  .find("25.4 times larger than the shape, as if the shape were in inches: give mesh_scale=0.03937"),
              std::string::npos)
        << refusal(model, larger);
    EXPECT_NE(refusal(model, elsewhere).find("(-100, 0, 0) mm"), std::string::npos) << refusal(model, elsewhere);
}

TEST(Matching, AMeshOfAnotherPartIsRefusedWithThePlace) {
    const auto box = geometry::make_shape_model(BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape());
    const auto ball = geometry::make_shape_model(BRepPrimAPI_MakeSphere(gp_Pnt(1, 1, 1), 1.0).Shape());
    EXPECT_NE(refusal(box, given_of(curved(ball, of_order(1)))).find("lie on no face of the shape"), std::string::npos);
}

TEST(Matching, AMeshWithoutAHoleOfThePartIsRefused) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 10, -2), gp::DZ()), 3.0, 40.0).Shape();
    const auto holed = geometry::make_shape_model(BRepAlgoAPI_Cut(box, drill).Shape());
    const GivenMesh mesh = given_of(curved(geometry::make_shape_model(box), of_order(1)));
    EXPECT_NE(refusal(holed, mesh).find("does not follow Edge"), std::string::npos) << refusal(holed, mesh);
}

TEST(Matching, AMeshOfAFilletedPartIsRefusedOnThePlainOne) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    int edges = 0;
    for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More() && edges < 4; edge.Next(), ++edges) {
        fillet.Add(2.0, TopoDS::Edge(edge.Current()));
    }
    const GivenMesh mesh = given_of(curved(geometry::make_shape_model(fillet.Shape()), of_order(1)));
    EXPECT_NE(refusal(geometry::make_shape_model(box), mesh), "");
}

}  // namespace
}  // namespace mq::given

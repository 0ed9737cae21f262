// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/edges/short_edges.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Ax1.hxx>

#include "geometry/parts.h"
#include "triangulate/checks.h"
#include "triangulate/initial/initial_triangulation.h"

namespace mq::triangulate {
namespace {

constexpr double kDetail = 1e-3;

/// A square with one corner cut off at this distance.
TopoDS_Face cut_square(double cut) {
    return geometry::planar_face({geometry::line(0.0, 0.0, 10.0, 0.0), geometry::line(10.0, 0.0, 10.0, 10.0 - cut),
                                  geometry::line(10.0, 10.0 - cut, 10.0 - cut, 10.0),
                                  geometry::line(10.0 - cut, 10.0, 0.0, 10.0), geometry::line(0.0, 10.0, 0.0, 0.0)});
}

struct Detailed {
    explicit Detailed(const TopoDS_Shape& shape)
        : model(geometry::make_shape_model(shape, nullptr, geometry::Creases::Keep,
                                           {[](const Box&) { return kDetail; }})),
          session(engine, model),
          grid(model->topology().box),
          initial(triangulate_initially(session, grid, progress)) {}

    geometry::Engine engine{geometry::Engine::Mode::Direct};
    std::shared_ptr<geometry::Model> model;
    geometry::Session session;
    SinglePrecisionGrid grid;
    Progress progress;
    InitialTriangulation initial;
};

int faces_with_area(const geometry::Topology& topology) {
    int count = 0;
    for (const geometry::Face& face : topology.faces) {
        count += face.no_area ? 0 : 1;
    }
    return count;
}

TEST(ShortEdges, AShortSideOfAFaceIsAVertex) {
    const Detailed part(cut_square(0.5 * kDetail));
    ASSERT_EQ(part.initial.chains.contracted().size(), 1u);
    EXPECT_TRUE(part.initial.failures.empty());
    std::set<int> used;
    for (const auto& t : part.initial.faces.front().triangles) {
        for (const int use : t) {
            used.insert(part.initial.faces.front().sites[use].vertex);
        }
    }
    EXPECT_EQ(used.size(), 4u);
}

TEST(ShortEdges, ALongerSideStays) {
    EXPECT_TRUE(Detailed(cut_square(2.0 * kDetail)).initial.chains.contracted().empty());
}

TEST(ShortEdges, EveryEdgeStaysWithoutADetail) {
    const auto model = geometry::make_shape_model(cut_square(0.5 * kDetail));
    geometry::Engine engine{geometry::Engine::Mode::Direct};
    geometry::Session session(engine, model);
    const SinglePrecisionGrid grid(model->topology().box);
    EXPECT_TRUE(EdgeDiscretisation(session, grid).contracted().empty());
}

/// Beside a square with a corner cut off, whose short side is contracted, a face with the same two vertices but a side
/// of its own between them, which may not be: its neighbours meet at 20 degrees.
TEST(ShortEdges, AnEdgeStaysWhereItsFaceCouldNotBeTriangulatedWithoutIt) {
    const double cut = 0.5 * kDetail;
    const auto vertex = [](double x, double y) { return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0.0)).Vertex(); };
    const auto line = [](const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
        return BRepBuilderAPI_MakeEdge(from, to).Edge();
    };
    const TopoDS_Vertex a = vertex(10.0, 10.0 - cut);
    const TopoDS_Vertex b = vertex(10.0 - cut, 10.0);
    const TopoDS_Vertex corner = vertex(0.0, 0.0);
    const TopoDS_Vertex low = vertex(10.0, 0.0);
    const TopoDS_Vertex left = vertex(0.0, 10.0);
    const TopoDS_Vertex far = vertex(16.0, 20.0);
    const TopoDS_Vertex farther = vertex(20.0, 16.0);
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(
        both, geometry::planar_face({line(corner, low), line(low, a), line(a, b), line(b, left), line(left, corner)}));
    builder.Add(both, geometry::planar_face({line(b, a), line(a, farther), line(farther, far), line(far, b)}));
    const Detailed part(both);
    EXPECT_TRUE(part.initial.failures.empty());
    EXPECT_TRUE(part.initial.chains.contracted().empty());
}

/// The strip beside a short edge of the base is thinner than the detail along its whole length.
TEST(ShortEdges, AThinFaceBetweenTwoOthersIsAnEdge) {
    const Detailed part(geometry::extruded(cut_square(0.5 * kDetail), 5.0));
    EXPECT_EQ(faces_with_area(part.model->topology()), 6);
    EXPECT_TRUE(part.initial.failures.empty());
    ASSERT_EQ(part.model->topology().faults.size(), 1u);
    EXPECT_NE(
        part.model->topology().faults[0].find("is thinner than 0.001 mm, which does not show at what is asked for"),
        std::string::npos);
}

/// The riser of a step has one edge below and three above, as a block stands flush with it on the step.
TEST(ShortEdges, AThinFaceWithMoreEdgesOnOneSideIsAnEdge) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(10.0, 4.0, 2.0).Shape();
    const TopoDS_Shape step = BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 2.0), 10.0, 2.0, 0.5 * kDetail).Shape();
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(3.0, 1.0, 2.0 + 0.5 * kDetail), 2.0, 1.0, 1.0).Shape();
    const Detailed part(BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(plate, step).Shape(), block).Shape());
    const geometry::Topology& topology = part.model->topology();
    EXPECT_TRUE(part.initial.failures.empty());
    ASSERT_FALSE(topology.faults.empty());
    for (const std::string& fault : topology.faults) {
        EXPECT_NE(fault.find("is thinner than 0.001 mm"), std::string::npos) << fault;
    }
    EXPECT_EQ(topology.parts_of[1].size(), 2u);  // the edge below is in three pieces
}

/// Two arcs meet beside the middle of a chord: their end is near it, and they are not.
TEST(ShortEdges, AnEdgeIsNotDividedAtANodeWhereNothingElseRunsAlongIt) {
    const double up = 0.5 * kDetail;
    const double radius = std::hypot(2.5, 0.5 * up) / std::sin(0.5);
    const double away = radius * std::cos(0.5);
    const auto bulge = [&](double from, double to, double from_y, double to_y) {
        const Vec3 middle(0.5 * (from + to), 0.5 * (from_y + to_y), 0.0);
        const Vec3 along = Vec3(to - from, to_y - from_y, 0.0).normalized();
        const Vec3 centre = middle - away * Vec3(-along.y(), along.x(), 0.0);
        const gp_Circ circle = geometry::circle_about(centre.x(), centre.y(), radius);
        const double first = std::atan2(to_y - centre.y(), to - centre.x());
        return geometry::arc(circle, first, first + 1.0);
    };
    const TopoDS_Face face = geometry::planar_face(
        {geometry::line(0.0, 0.0, 10.0, 0.0), bulge(5.0, 10.0, up, 0.0), bulge(0.0, 5.0, 0.0, up)});
    const Detailed part(geometry::extruded(face, 5.0));
    EXPECT_EQ(faces_with_area(part.model->topology()), 5);
    EXPECT_TRUE(part.model->topology().parts_of[1].empty());
}

TEST(ShortEdges, AThinRingIsAnEdge) {
    const TopoDS_Face profile = geometry::planar_face(
        {geometry::line(0.0, 0.0, 4.0, 0.0), geometry::line(4.0, 0.0, 5.0, 1.0),
         geometry::line(5.0, 1.0, 5.0, 1.0 + 0.5 * kDetail), geometry::line(5.0, 1.0 + 0.5 * kDetail, 4.0, 2.0),
         geometry::line(4.0, 2.0, 0.0, 2.0), geometry::line(0.0, 2.0, 0.0, 0.0)});
    const Detailed part(BRepPrimAPI_MakeRevol(profile, gp_Ax1(gp_Pnt(), gp_Dir(0.0, 1.0, 0.0))).Shape());
    EXPECT_TRUE(part.initial.failures.empty());
    EXPECT_EQ(faces_with_area(part.model->topology()), 4);
    ASSERT_EQ(part.model->topology().faults.size(), 1u);
    EXPECT_NE(part.model->topology().faults[0].find("is thinner than 0.001 mm"), std::string::npos);
}

/// Its top and bottom would lie on each other.
TEST(ShortEdges, AThinPlateStaysASolid) {
    const Detailed part(BRepPrimAPI_MakeBox(10.0, 10.0, 0.5 * kDetail).Shape());
    EXPECT_EQ(faces_with_area(part.model->topology()), 6);
    EXPECT_TRUE(part.initial.chains.contracted().empty());
    EXPECT_TRUE(part.model->topology().faults.empty());
}

TEST(ShortEdges, AThinRodStaysASolid) {
    const Detailed part(BRepPrimAPI_MakeBox(10.0, 0.4 * kDetail, 0.5 * kDetail).Shape());
    EXPECT_EQ(faces_with_area(part.model->topology()), 6);
    EXPECT_TRUE(part.initial.chains.contracted().empty());
}

}  // namespace
}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "geometry/parts.h"

namespace mq::geometry {
namespace {

TopoDS_Vertex vertex(double x, double y, double z) {
    return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, z)).Vertex();
}

TopoDS_Edge line(const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
    return BRepBuilderAPI_MakeEdge(from, to).Edge();
}

/// A square in the plane z = 0 between (0, 0) and (1, 1) whose right side goes on to y = 2 and back, with this width
/// there. Beyond either side of the spike lies a face: one in the plane, and one that rises at this angle, radians.
TopoDS_Shell spiked(double width, double rise) {
    const TopoDS_Vertex a = vertex(0.0, 0.0, 0.0);
    const TopoDS_Vertex b = vertex(1.0, 0.0, 0.0);
    const TopoDS_Vertex tip = vertex(1.0, 2.0, 0.0);
    const TopoDS_Vertex c = vertex(1.0 - width, 1.0, 0.0);
    const TopoDS_Vertex d = vertex(0.0, 1.0, 0.0);
    const TopoDS_Vertex left = vertex(0.0, 2.0, 0.0);
    const TopoDS_Vertex low = vertex(1.0 + std::cos(rise), 0.0, std::sin(rise));
    const TopoDS_Vertex high = vertex(1.0 + std::cos(rise), 2.0, std::sin(rise));
    const TopoDS_Edge longer = line(b, tip);
    const TopoDS_Edge shorter = line(tip, c);
    const TopoDS_Edge top = line(c, d);
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    builder.Add(shell, planar_face({line(a, b), longer, shorter, top, line(d, a)}));
    builder.Add(shell, planar_face({shorter, line(tip, left), line(left, d), top}));
    builder.Add(shell, planar_face({longer, line(b, low), line(low, high), line(high, tip)}));
    return shell;
}

/// A square in the plane z = 0 between (0, 0) and (1, 1) from whose corner a strip of this width goes to (2, 2), as
/// where two parts of a body are a little out of place. Left of the strip lies a face in the plane, right of it one
/// that rises.
TopoDS_Shell with_strip(double width) {
    const double e = width / std::sqrt(2.0);
    const TopoDS_Vertex a = vertex(0.0, 0.0, 0.0);
    const TopoDS_Vertex b = vertex(1.0, 0.0, 0.0);
    const TopoDS_Vertex right = vertex(1.0, 1.0 - e, 0.0);
    const TopoDS_Vertex right_tip = vertex(2.0, 2.0 - e, 0.0);
    const TopoDS_Vertex left_tip = vertex(2.0 - e, 2.0, 0.0);
    const TopoDS_Vertex left = vertex(1.0 - e, 1.0, 0.0);
    const TopoDS_Vertex d = vertex(0.0, 1.0, 0.0);
    const TopoDS_Vertex far = vertex(0.0, 2.0, 0.0);
    const TopoDS_Vertex low = vertex(2.0, 1.0 - e, 1.0);
    const TopoDS_Edge first = line(right, right_tip);
    const TopoDS_Edge second = line(left_tip, left);
    const TopoDS_Edge top = line(left, d);
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    builder.Add(shell,
                planar_face({line(a, b), line(b, right), first, line(right_tip, left_tip), second, top, line(d, a)}));
    builder.Add(shell, planar_face({second, line(left_tip, far), line(far, d), top}));
    builder.Add(shell, planar_face({first, line(right, low), line(low, right_tip)}));
    return shell;
}

/// The face between x = 1 and a border that leaves it at a tip this far above y = 1, lies this much to its left at y =
/// 1 and that much at y = 0. Beyond the border lies a face in the plane, beyond x = 1 one that rises.
TopoDS_Shell tapering(double length, double at_one, double at_zero) {
    const TopoDS_Vertex tip = vertex(1.0, 1.0 + length, 0.0);
    const TopoDS_Vertex middle = vertex(1.0 - at_one, 1.0, 0.0);
    const TopoDS_Vertex foot = vertex(1.0, 0.0, 0.0);
    const TopoDS_Vertex end = at_zero > 0.0 ? vertex(1.0 - at_zero, 0.0, 0.0) : foot;
    const TopoDS_Vertex low = vertex(0.0, 0.0, 0.0);
    const TopoDS_Vertex left = vertex(0.0, 2.0, 0.0);
    const TopoDS_Vertex risen = vertex(2.0, 1.0, 1.0);
    const TopoDS_Edge longer = line(foot, tip);
    const TopoDS_Edge shorter = line(tip, middle);
    const TopoDS_Edge beyond = line(middle, end);
    std::vector<TopoDS_Edge> edges{longer, shorter, beyond};
    if (at_zero > 0.0) {
        edges.push_back(line(end, foot));
    }
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    builder.Add(shell, planar_face(edges));
    builder.Add(shell, planar_face({shorter, line(tip, left), line(left, low), line(low, end), beyond}));
    builder.Add(shell, planar_face({longer, line(foot, risen), line(risen, tip)}));
    return shell;
}

/// A face in the plane z = 0 between y = 0, as far as x = 10, and a curve from the origin. Beyond the curve lies a face
/// in the plane, beyond y = 0 one that rises.
TopoDS_Shell with_curved_side(const Handle(Geom_Curve) & curve, double tolerance) {
    const TopoDS_Vertex tip = vertex(0.0, 0.0, 0.0);
    const TopoDS_Vertex low = vertex(10.0, 0.0, 0.0);
    const gp_Pnt end = curve->Value(curve->LastParameter());
    const TopoDS_Vertex high = vertex(end.X(), end.Y(), 0.0);
    const TopoDS_Vertex top = vertex(end.X() - 10.0, end.Y(), 0.0);
    const TopoDS_Vertex risen = vertex(10.0, -1.0, 1.0);
    const TopoDS_Edge straight = line(tip, low);
    const TopoDS_Edge curved = BRepBuilderAPI_MakeEdge(curve, tip, high).Edge();
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.UpdateEdge(curved, tolerance);
    builder.MakeShell(shell);
    builder.Add(shell, planar_face({straight, line(low, high), curved}));
    builder.Add(shell, planar_face({curved, line(high, top), line(top, tip)}));
    builder.Add(shell, planar_face({straight, line(low, risen), line(risen, tip)}));
    return shell;
}

/// The curve leaves y = 0 at the origin and dips 0.001 mm below it as far as x = 0.64.
TopoDS_Shell crossing_beside_a_vertex(double tolerance) {
    TColgp_Array1OfPnt poles(1, 4);
    poles(1) = gp_Pnt(0.0, 0.0, 0.0);
    poles(2) = gp_Pnt(2.5, -0.01, 0.0);
    poles(3) = gp_Pnt(6.0, 0.0, 0.0);
    poles(4) = gp_Pnt(10.0, 3.0, 0.0);
    return with_curved_side(new Geom_BezierCurve(poles), tolerance);
}

/// Straight pieces from corner to corner. @param knots  the parameters of the corners
Handle(Geom_Curve) polyline(const std::vector<gp_Pnt>& corners, const std::vector<double>& knots) {
    const int count = static_cast<int>(corners.size());
    TColgp_Array1OfPnt poles(1, count);
    TColStd_Array1OfReal parameters(1, count);
    TColStd_Array1OfInteger multiplicities(1, count);
    for (int i = 1; i <= count; ++i) {
        poles(i) = corners[static_cast<std::size_t>(i - 1)];
        parameters(i) = knots[static_cast<std::size_t>(i - 1)];
        multiplicities(i) = i == 1 || i == count ? 2 : 1;
    }
    return new Geom_BSplineCurve(poles, parameters, multiplicities, 1);
}

/// The curve runs along y = 0 as far as x = 2, for a thousandth of its parameters, and turns off there.
TopoDS_Shell turning_off_a_line() {
    return with_curved_side(polyline({{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {10.0, 3.0, 0.0}}, {0.0, 1e-3, 1.0}), 1e-7);
}

/// The curve turns off y = 0 at x = 0.5 and goes to and fro: half of its length is more than its largest distance from
/// the origin.
TopoDS_Shell turning_off_to_and_fro() {
    return with_curved_side(polyline({{0.0, 0.0, 0.0},
                                      {0.5, 0.0, 0.0},
                                      {1.0, 1.0, 0.0},
                                      {0.2, 1.2, 0.0},
                                      {1.0, 1.5, 0.0},
                                      {0.2, 1.8, 0.0},
                                      {1.0, 2.1, 0.0},
                                      {0.0, 2.4, 0.0}},
                                     {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}),
                            1e-7);
}

/// A detail of 0.005 mm.
VirtualTopology finely() {
    return {[](const Box&) { return 5e-3; }, true};
}

/// Whether the faults of the model name a spike of the first face.
bool has_spike(const Topology& topology) {
    for (const std::string& fault : topology.faults) {
        if (fault.find("Face1: has a spike between Edge") == 0) {
            return true;
        }
    }
    return false;
}

TEST(Spikes, ASpikeIsTakenOffAndTheFacesBesideItMeet) {
    for (const double width : {0.0, 1e-8, 1e-3}) {
        const auto model = make_shape_model(spiked(width, 0.5), nullptr, Creases::Keep, finely());
        const Topology& topology = model->topology();
        EXPECT_TRUE(has_spike(topology)) << width;
        EXPECT_EQ(topology.faces[0].loops.front().uses.size(), 4U) << width;
        int between = 0;
        for (const Edge& edge : topology.edges) {
            ASSERT_LE(edge.uses.size(), 2U);
            if (edge.uses.size() == 2) {
                const int f = topology.uses[static_cast<std::size_t>(edge.uses[0])].face;
                const int g = topology.uses[static_cast<std::size_t>(edge.uses[1])].face;
                between += std::min(f, g) == 1 && std::max(f, g) == 2 ? 1 : 0;
            }
        }
        EXPECT_EQ(between, 1) << width;
    }
}

TEST(Spikes, AStripWhoseSidesEndBesideEachOtherIsTakenOffWhole) {
    const auto model = make_shape_model(with_strip(2e-3), nullptr, Creases::Keep, finely());
    const Topology& topology = model->topology();
    EXPECT_TRUE(has_spike(topology));
    EXPECT_EQ(topology.faces[0].loops.front().uses.size(), 4U);
    EXPECT_EQ(topology.edges.size(), topology.own_count(1));  // nothing was divided
    EXPECT_FALSE(has_spike(make_shape_model(with_strip(2e-2), nullptr, Creases::Keep, finely())->topology()));
}

/// The smallest corner of the first face at a point in the shape, radians; -1: it has none there.
double corner_at(Model& model, const Vec3& point) {
    for (int n = 0; n < static_cast<int>(model.topology().nodes.size()); ++n) {
        if ((model.topology().nodes[static_cast<std::size_t>(n)].point - point).norm() < 1e-9) {
            return model.corner_angle(0, n).value_or(-1.0);
        }
    }
    return -1.0;
}

TEST(Spikes, TheCornersOfTheShapeStayKnown) {
    const double width = 1e-3;
    const auto model = make_shape_model(spiked(width, 0.5), nullptr, Creases::Keep, finely());
    EXPECT_NEAR(corner_at(*model, Vec3(1.0, 0.0, 0.0)), 0.5 * M_PI, 1e-9);
    EXPECT_NEAR(corner_at(*model, Vec3(1.0, 2.0, 0.0)), std::atan(width), 1e-9);
    EXPECT_NEAR(corner_at(*model, Vec3(1.0 - width, 1.0, 0.0)), 1.5 * M_PI - std::atan(width), 1e-9);
    EXPECT_EQ(corner_at(*model, Vec3(0.0, 2.0, 0.0)), -1.0);
    EXPECT_TRUE(model->topology().joined.empty());  // the narrow corner is the shape's: it only moves
}

TEST(Spikes, ANarrowCornerMayBeLeftWhereANarrowerOneIsTakenOff) {
    const auto wider = make_shape_model(tapering(1.0, 1e-3, 0.2), nullptr, Creases::Keep, finely());
    EXPECT_TRUE(has_spike(wider->topology()));
    EXPECT_EQ(wider->topology().faces[0].loops.front().uses.size(), 3U);
    const auto narrower = make_shape_model(tapering(0.02, 4e-3, 6e-3), nullptr, Creases::Keep, finely());
    EXPECT_FALSE(has_spike(narrower->topology()));
    EXPECT_EQ(narrower->topology().faces[0].loops.front().uses.size(), 4U);
}

TEST(Spikes, AThinFaceWithUnequalNumbersOfEdgesIsNoFace) {
    const auto model = make_shape_model(tapering(1.0, 1e-3, 0.0), nullptr, Creases::Keep, finely());
    const Topology& topology = model->topology();
    EXPECT_FALSE(has_spike(topology));  // its longer edge is divided at the node across
    ASSERT_EQ(topology.faults.size(), 1U);
    EXPECT_NE(topology.faults[0].find("Face1: is thinner than"), std::string::npos) << topology.faults[0];
    EXPECT_TRUE(topology.faces[0].no_area);
    EXPECT_TRUE(topology.faces[0].loops.empty());
    const auto shared = std::count_if(topology.edges.begin(), topology.edges.end(),
                                      [](const Edge& edge) { return edge.uses.size() == 2; });
    EXPECT_EQ(shared, 2);
}

TEST(Spikes, WiderOnesStayAndThoseBetweenFacesThatLieOnEachOther) {
    const auto wide = make_shape_model(spiked(1e-2, 0.5), nullptr, Creases::Keep, finely());
    EXPECT_FALSE(has_spike(wide->topology()));
    const auto folded = make_shape_model(spiked(1e-3, M_PI - 0.1), nullptr, Creases::Keep, finely());
    EXPECT_FALSE(has_spike(folded->topology()));
}

TEST(Spikes, EdgesThatCrossBesideTheirVertexAreOneUpToTheirTolerance) {
    const double tolerance = 5e-3;
    const auto model = make_shape_model(crossing_beside_a_vertex(tolerance), nullptr, Creases::Keep, finely());
    const Topology& topology = model->topology();
    ASSERT_EQ(topology.faults.size(), 1U);
    EXPECT_EQ(topology.faults[0].find("Face1: Edge"), 0U) << topology.faults[0];
    EXPECT_NE(topology.faults[0].find(
                  "cross or coincide beside their vertex: they are one edge up to where they are 0.005 mm apart"),
              std::string::npos);
    EXPECT_EQ(topology.faces[0].loops.front().uses.size(), 3U);
    ASSERT_EQ(topology.nodes.size(), 6U);
    const Vec3& tip = topology.nodes.back().point;
    EXPECT_GT(tip.x(), 0.7);  // 0.64 is where they cross
    EXPECT_LT(tip.x(), 1.5);
    EXPECT_NEAR(tip.y(), 0.5 * tolerance, 1e-4);
    const auto between = std::count_if(topology.edges.begin(), topology.edges.end(), [&](const Edge& edge) {
        return edge.uses.size() == 2 && topology.uses[static_cast<std::size_t>(edge.uses[0])].face > 0 &&
               topology.uses[static_cast<std::size_t>(edge.uses[1])].face > 0;
    });
    EXPECT_EQ(between, 1);
}

TEST(Spikes, EdgesThatRunOutAndBackAlongALineAreOneUpToWhereOneTurnsOff) {
    for (const auto& [shell, turn] : {std::pair{turning_off_a_line(), 2.0}, std::pair{turning_off_to_and_fro(), 0.5}}) {
        const auto model = make_shape_model(shell, nullptr, Creases::Keep, finely());
        const Topology& topology = model->topology();
        ASSERT_EQ(topology.nodes.size(), 6U) << turn;
        EXPECT_LT((topology.nodes.back().point - Vec3(turn, 0.0, 0.0)).norm(), 1e-6);
        EXPECT_EQ(topology.faces[0].loops.front().uses.size(), 3U) << turn;
    }
}

TEST(Spikes, EdgesThatCrossByMoreThanTheirToleranceStay) {
    const auto model = make_shape_model(crossing_beside_a_vertex(1e-7), nullptr, Creases::Keep, finely());
    EXPECT_EQ(model->topology().nodes.size(), 5U);
}

}  // namespace
}  // namespace mq::geometry

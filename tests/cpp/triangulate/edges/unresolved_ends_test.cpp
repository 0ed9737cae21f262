// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/edges/unresolved_ends.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <algorithm>

#include "geometry/parts.h"
#include "geometry/session.h"

namespace mq::triangulate {
namespace {

/// The stretches of all ends of edges of a shape, with lengths of 10 mm for all edges but degenerate ones.
std::vector<std::array<double, 2>> stretches(const TopoDS_Shape& shape) {
    geometry::Engine engine{geometry::Engine::Mode::Direct};
    geometry::Session session(engine, geometry::make_shape_model(shape));
    const SinglePrecisionGrid grid(session.topology().box);
    std::vector<double> lengths;
    for (const geometry::Edge& edge : session.topology().edges) {
        lengths.push_back(edge.degenerate ? 0.0 : 10.0);
    }
    return unresolved_ends(session, grid, lengths);
}

double largest(const std::vector<std::array<double, 2>>& ends) {
    double result = 0.0;
    for (const auto& [first, last] : ends) {
        result = std::max({result, first, last});
    }
    return result;
}

TopoDS_Edge arc(const gp_Pnt& from, const gp_Pnt& through, const gp_Pnt& to) {
    return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, through, to).Value()).Edge();
}

TEST(UnresolvedEnds, ThereAreNoneAtCornersOfABox) {
    EXPECT_EQ(largest(stretches(BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape())), 0.0);
}

TEST(UnresolvedEnds, ArcsThatAreTangentInTheirCornersAreNotToldApartThere) {
    // Between circles of radius 10 and 20 through the origin, cut off by a line.
    const gp_Pnt tip(0.0, 0.0, 0.0);
    const auto on = [](double radius, double turn) {
        return gp_Pnt(radius * std::sin(turn), radius * (1.0 - std::cos(turn)), 0.0);
    };
    const TopoDS_Edge inner = arc(tip, on(10.0, 0.5), on(10.0, 1.0));
    const TopoDS_Edge outer = arc(on(20.0, 0.5), on(20.0, 0.25), tip);
    const TopoDS_Edge end = BRepBuilderAPI_MakeEdge(on(10.0, 1.0), on(20.0, 0.5)).Edge();
    const auto ends = stretches(geometry::planar_face({inner, end, outer}));
    // At the distance s they are s^2 (1 / 20 - 1 / 40) apart, and single precision resolves 1e-6.
    EXPECT_GT(largest(ends), 1e-3);
    EXPECT_LT(largest(ends), 0.05);
    int with = 0;
    for (const auto& [first, last] : ends) {
        with += (first > 0.0 ? 1 : 0) + (last > 0.0 ? 1 : 0);
    }
    EXPECT_EQ(with, 2) << "the two arcs at their common node alone";
}

}  // namespace
}  // namespace mq::triangulate

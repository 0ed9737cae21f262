// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cmath>
#include <string>
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

TEST(Spikes, WiderOnesStayAndThoseBetweenFacesThatLieOnEachOther) {
    const auto wide = make_shape_model(spiked(1e-2, 0.5), nullptr, Creases::Keep, finely());
    EXPECT_FALSE(has_spike(wide->topology()));
    const auto folded = make_shape_model(spiked(1e-3, M_PI - 0.1), nullptr, Creases::Keep, finely());
    EXPECT_FALSE(has_spike(folded->topology()));
}

}  // namespace
}  // namespace mq::geometry

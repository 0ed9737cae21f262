// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/border_contacts.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <string>
#include <vector>

#include "geometry/occt/shape_model.h"

namespace mq::geometry {
namespace {

constexpr double kDetail = 1e-3;

/// A block with a conical hole that is this far from the front of its top (mm).
TopoDS_Shape block_with_hole(double gap) {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(20.0, 12.0, 8.0).Shape();
    const gp_Ax2 down(gp_Pnt(9.0, 3.0 + gap, 8.0), gp_Dir(0.0, 0.0, -1.0));
    return BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCone(down, 3.0, 1.5, 8.0).Shape()).Shape();
}

/// A cylinder with a hole that touches its seam.
TopoDS_Shape cylinder_with_hole() {
    const gp_Ax2 along_x(gp_Pnt(0.0, 0.75, 5.0), gp_Dir(1.0, 0.0, 0.0));
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(2.0, 15.0).Shape(),
                           BRepPrimAPI_MakeCylinder(along_x, 0.75, 3.0).Shape())
        .Shape();
}

Topology topology_of(const TopoDS_Shape& shape, CornerCuts cuts) {
    VirtualTopology join{[](const Box&) { return kDetail; }};
    join.corner_cuts = cuts;
    return make_shape_model(shape, nullptr, Creases::Keep, join)->topology();
}

/// The largest number of ends of edges that the border of a face has in one of its nodes.
std::ptrdiff_t most_ends(const Topology& topology, const Face& face) {
    std::vector<int> ends;
    for (const Loop& loop : face.loops) {
        for (const int use : loop.uses) {
            const Edge& edge =
                topology.edges[static_cast<std::size_t>(topology.uses[static_cast<std::size_t>(use)].edge)];
            ends.insert(ends.end(), edge.nodes.begin(), edge.nodes.end());
        }
    }
    std::ptrdiff_t most = 0;
    for (const int node : ends) {
        most = std::max(most, std::count(ends.begin(), ends.end(), node));
    }
    return most;
}

/// The face with the most loops.
const Face& holed(const Topology& topology) {
    return *std::max_element(topology.faces.begin(), topology.faces.end(),
                             [](const Face& a, const Face& b) { return a.loops.size() < b.loops.size(); });
}

std::ptrdiff_t count(const Topology& topology, const std::string& words) {
    return std::count_if(topology.faults.begin(), topology.faults.end(),
                         [&](const std::string& fault) { return fault.find(words) != std::string::npos; });
}

TEST(BorderContacts, AHoleBesideAnEdgeTouchesItWithinHalfOfTheDetail) {
    for (const double gap : {0.01, 0.4, 0.6, 3.0}) {
        const Topology topology = topology_of(block_with_hole(gap * kDetail), CornerCuts::None);
        const bool touches = gap < 0.5;
        EXPECT_EQ(count(topology, "count as touching each other"), touches ? 1 : 0) << gap;
        EXPECT_EQ(most_ends(topology, holed(topology)), touches ? 4 : 2) << gap;
        EXPECT_TRUE(topology.cut_corners.empty()) << gap;
    }
}

TEST(BorderContacts, APinchedFaceIsOpenedOnBothSidesOfTheNode) {
    for (const double gap : {0.0, 0.01, 0.4}) {
        const Topology kept = topology_of(block_with_hole(gap * kDetail), CornerCuts::None);
        const Topology cut = topology_of(block_with_hole(gap * kDetail), CornerCuts::Infeasible);
        EXPECT_EQ(cut.cut_corners.size(), 2u) << gap;
        EXPECT_EQ(count(cut, "is cut off where it is 0.001 mm wide"), 2) << gap;
        const auto top = static_cast<std::size_t>(&holed(kept) - kept.faces.data());
        EXPECT_EQ(most_ends(kept, kept.faces[top]), 4) << gap;
        EXPECT_EQ(most_ends(cut, cut.faces[top]), 2) << gap;
        EXPECT_EQ(cut.faces[top].loops.size(), 1u) << gap;  // the hole and the outer border are one
        for (const Edge& edge : cut.edges) {
            EXPECT_TRUE(edge.uses.empty() || edge.uses.size() == 2) << gap;
        }
    }
}

TEST(BorderContacts, ASeamThatTouchesAHoleGivesWay) {
    const Topology topology = topology_of(cylinder_with_hole(), CornerCuts::Infeasible);
    EXPECT_EQ(topology.cut_corners.size(), 2u);
    EXPECT_EQ(topology_of(cylinder_with_hole(), CornerCuts::None).cut_corners.size(), 0u);
}

TEST(BorderContacts, CornersOfOneBorderStay) {
    const Topology topology = topology_of(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(), CornerCuts::Infeasible);
    EXPECT_TRUE(topology.cut_corners.empty());
    EXPECT_TRUE(topology.faults.empty());
}

}  // namespace
}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/topology.h"

#include <gtest/gtest.h>

namespace mq::geometry {
namespace {

/// A face with a square border and a slit, which was cut into two pieces along the slit.
Topology cut_square() {
    Topology topology;
    topology.nodes.resize(6);
    topology.edges.resize(5);
    topology.faces.resize(3);
    for (int e = 0; e < 5; ++e) {
        topology.uses.push_back({e, 0, true, e == 4});
    }
    topology.faces[0].loops = {{{0, 1, 2, 3}}, {{4}}};
    topology.parts_of[2] = {{2, 0}, {2, 0}};
    topology.parts_of[1] = {{2, 0}};
    return topology;
}

TEST(Topology, EntitiesHaveFreeCadsNames) {
    EXPECT_EQ(name_of({0, 2}), "Vertex3");
    EXPECT_EQ(name_of({1, 11}), "Edge12");
    EXPECT_EQ(name_of({2, 0}), "Face1");
}

TEST(Topology, PiecesBelongToTheEntityThatWasCut) {
    const Topology topology = cut_square();
    EXPECT_TRUE(topology.has_pieces());
    EXPECT_EQ(topology.own_count(0), 6u);
    EXPECT_EQ(topology.own_count(1), 4u);
    EXPECT_EQ(topology.own_count(2), 1u);
    EXPECT_EQ(topology.name_of({2, 2}), "Face1");
    EXPECT_EQ(topology.name_of({1, 4}), "a crease of Face1");
    EXPECT_EQ(topology.name_of({1, 3}), "Edge4");
    EXPECT_EQ(topology.pieces_of({2, 0}), (std::vector<int>{0, 1, 2})) << "itself and its further pieces";
    EXPECT_EQ(topology.pieces_of({1, 2}), std::vector<int>{2});
    EXPECT_FALSE(Topology().has_pieces());
}

TEST(Topology, EdgesOfAFaceAreThoseAroundAndInsideIt) {
    EXPECT_EQ(cut_square().edges_of(0), (std::set<int>{0, 1, 2, 3, 4}));
    EXPECT_TRUE(cut_square().edges_of(1).empty());
}

}  // namespace
}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/node_orders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace mq::curve {
namespace {

/// Exponents of all corners but the first, node by node, in the order of the format.
std::string text_of(const Lattice& lattice, const std::vector<int>& order) {
    std::string text;
    for (const int i : order) {
        text += text.empty() ? "" : " ";
        for (std::size_t k = 1; k <= static_cast<std::size_t>(lattice.dimension()); ++k) {
            text += std::to_string(lattice.exponents(i)[k]);
        }
    }
    return text;
}

std::string gmsh_text(int dimension, int order) {
    const Lattice& lattice = Lattice::of(dimension, order);
    return text_of(lattice, gmsh_order(lattice));
}

// The orders that Gmsh 4.8 itself gives for its element types.
TEST(GmshOrder, Lines) {
    EXPECT_EQ(gmsh_text(1, 2), "0 2 1");
    EXPECT_EQ(gmsh_text(1, 5), "0 5 1 2 3 4");
}

TEST(GmshOrder, Triangles) {
    EXPECT_EQ(gmsh_text(2, 1), "00 10 01");
    EXPECT_EQ(gmsh_text(2, 2), "00 20 02 10 11 01");
    EXPECT_EQ(gmsh_text(2, 3), "00 30 03 10 20 21 12 02 01 11");
    EXPECT_EQ(gmsh_text(2, 4), "00 40 04 10 20 30 31 22 13 03 02 01 11 21 12");
    EXPECT_EQ(gmsh_text(2, 5), "00 50 05 10 20 30 40 41 32 23 14 04 03 02 01 11 31 13 21 22 12");
}

TEST(GmshOrder, Tetrahedra) {
    EXPECT_EQ(gmsh_text(3, 2), "000 200 020 002 100 110 010 001 011 101");
    EXPECT_EQ(gmsh_text(3, 3), "000 300 030 003 100 200 210 120 020 010 002 001 012 021 102 201 110 101 011 111");
    EXPECT_EQ(gmsh_text(3, 4),
              "000 400 040 004 100 200 300 310 220 130 030 020 010 003 002 001 013 022 031 103 202 301 110 120 210 "
              "101 201 102 011 012 021 112 211 121 111");
}

TEST(VtkOrder, HasEveryNodeOnceAndItsOwnEdges) {
    const Lattice& lattice = Lattice::of(3, 2);
    EXPECT_EQ(text_of(lattice, vtk_order(lattice)), "000 200 020 002 100 110 010 001 101 011");
    for (int order = 1; order <= 4; ++order) {
        std::vector<int> points = vtk_order(Lattice::of(3, order));
        std::sort(points.begin(), points.end());
        for (int i = 0; i < Lattice::of(3, order).size(); ++i) {
            EXPECT_EQ(points[static_cast<std::size_t>(i)], i);
        }
    }
}

}  // namespace
}  // namespace mq::curve

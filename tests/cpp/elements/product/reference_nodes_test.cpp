// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/reference_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "base/error.h"
#include "elements/product/polynomial_map.h"

namespace mq::elements {
namespace {

/// The nodes from `first` on, each by its three whole numbers.
std::string text_of(ElementKind kind, int order, std::size_t first = 0) {
    std::string text;
    const std::vector<GridPoint> nodes = gmsh_nodes(kind, order);
    for (std::size_t i = first; i < nodes.size(); ++i) {
        text += text.empty() ? "" : " ";
        for (const int coordinate : nodes[i]) {
            text += std::to_string(coordinate);
        }
    }
    return text;
}

// The orders that Gmsh 4.8 itself gives for its element types.
TEST(ReferenceNodes, AreThoseOfGmsh) {
    EXPECT_EQ(text_of(ElementKind::Quadrilateral, 2), "000 200 220 020 100 210 120 010 110");
    EXPECT_EQ(text_of(ElementKind::Quadrilateral, 3),
              "000 300 330 030 100 200 310 320 230 130 020 010 110 210 220 120");
    EXPECT_EQ(text_of(ElementKind::Tetrahedron, 2), "000 200 020 002 100 110 010 001 011 101");
    EXPECT_EQ(text_of(ElementKind::Prism, 2),
              "000 200 020 002 202 022 100 010 001 110 201 021 102 012 112 101 011 111");
    EXPECT_EQ(text_of(ElementKind::Prism, 4, 66), "111 113 112 211 213 212 121 123 122");
    EXPECT_EQ(text_of(ElementKind::Hexahedron, 2),
              "000 200 220 020 002 202 222 022 100 010 001 210 201 120 221 021 102 012 212 122 110 101 011 211 121 112 "
              "111");
    EXPECT_EQ(text_of(ElementKind::Pyramid, 1), "-1-10 1-10 110 -110 001");
    EXPECT_EQ(text_of(ElementKind::Pyramid, 2, 5), "0-20 -200 -1-11 200 1-11 020 111 -111 000");
    EXPECT_EQ(text_of(ElementKind::Pyramid, 3, 21), "0-21 -201 201 021 -1-10 -110 110 1-10 001");
}

TEST(ReferenceNodes, EachOccursOnce) {
    for (const ElementKind kind : kAllKinds) {
        for (int order = 1; order <= 5; ++order) {
            const std::vector<GridPoint> nodes = gmsh_nodes(kind, order);
            EXPECT_EQ(static_cast<int>(nodes.size()), full_node_count(kind, order));
            EXPECT_EQ(std::set<GridPoint>(nodes.begin(), nodes.end()).size(), nodes.size()) << name_of(kind) << order;
        }
    }
}

TEST(ReferenceNodes, LieOnGmshsReferenceElements) {
    const std::vector<Vec3> prism = reference_nodes(ElementKind::Prism, 2);
    EXPECT_EQ(prism[0], Vec3(0.0, 0.0, -1.0));
    EXPECT_EQ(prism[10], Vec3(1.0, 0.0, 0.0));
    const std::vector<Vec3> pyramid = reference_nodes(ElementKind::Pyramid, 4);
    EXPECT_EQ(pyramid[4], Vec3(0.0, 0.0, 1.0));
    EXPECT_EQ(pyramid[5], Vec3(-0.5, -1.0, 0.0));
    EXPECT_EQ(reference_nodes(ElementKind::Hexahedron, 2)[26], Vec3(0.0, 0.0, 0.0));
}

TEST(ReferenceNodes, OrdersHaveLimits) {
    EXPECT_THROW(gmsh_nodes(ElementKind::Hexahedron, 0), InvalidInput);
    EXPECT_THROW(gmsh_nodes(ElementKind::Hexahedron, 6), InvalidInput);
}

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
}  // namespace mq::elements

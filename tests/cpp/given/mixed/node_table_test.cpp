// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/node_table.h"

#include <gtest/gtest.h>

#include <set>

#include "elements/product/reference_nodes.h"
#include "given/mixed/blocks.h"

namespace mq::given {

using elements::ElementKind;

namespace {

TEST(NodeTable, NodesOfStraightElementsAreThoseOfTheReferenceElement) {
    for (const ElementKind kind : {ElementKind::Triangle, ElementKind::Quadrilateral, ElementKind::Tetrahedron,
                                   ElementKind::Pyramid, ElementKind::Prism, ElementKind::Hexahedron}) {
        const std::vector<Vec3> corners = elements::reference_nodes(kind, 1);
        std::vector<std::int32_t> numbers;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            numbers.push_back(static_cast<std::int32_t>(i));
        }
        for (int order = 1; order <= 4; ++order) {
            NodeTable table(order, corners);
            const std::vector<std::int32_t> nodes = table.nodes_of(kind, numbers.data());
            const std::vector<Vec3> places = elements::reference_nodes(kind, order);
            ASSERT_EQ(nodes.size(), places.size());
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                EXPECT_NEAR((table.straight()[static_cast<std::size_t>(nodes[i])] - places[i]).norm(), 0.0, 1e-12)
                    << elements::name_of(kind) << " " << order << " " << i;
            }
        }
    }
}

TEST(NodeTable, NeighboursShareTheNodesOfTheirFace) {
    const MixedMesh mesh = cubes(2, 3, 1);
    for (int order = 1; order <= 4; ++order) {
        NodeTable table(order, mesh.nodes);
        std::set<std::int32_t> all;
        for (const MixedElement& element : mesh.elements) {
            const auto nodes = table.nodes_of(element.kind, element.corners.data());
            all.insert(nodes.begin(), nodes.end());
        }
        const auto count = static_cast<std::size_t>((2 * order + 1) * (3 * order + 1) * (order + 1));
        EXPECT_EQ(all.size(), count);
        EXPECT_EQ(table.straight().size(), count);
        const auto forth = table.edge(0, 1);
        const auto back = table.edge(1, 0);
        EXPECT_TRUE(std::equal(forth.begin(), forth.end(), back.rbegin()));
        EXPECT_EQ(table.straight().size(), count);
    }
}

}  // namespace
}  // namespace mq::given

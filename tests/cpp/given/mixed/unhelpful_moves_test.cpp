// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/unhelpful_moves.h"

#include <gtest/gtest.h>

namespace mq::given {

using elements::ElementKind;

namespace {

/// Lines of elements: 0 and 1 share node 1, element 2 stands alone.
std::vector<ElementNodes> elements() {
    return {{ElementKind::Hexahedron, {0, 1}}, {ElementKind::Hexahedron, {1, 2}}, {ElementKind::Hexahedron, {3, 4}}};
}

TEST(KeptChanges, GroupsThatGainNothingGoBack) {
    const std::vector<Vec3> before(5, Vec3::Zero());
    std::vector<Vec3> nodes(5, Vec3::Zero());
    nodes[1] = nodes[4] = Vec3::UnitX();
    // The first two exchange a fault, the third loses one.
    EXPECT_EQ(revert_unhelpful_moves(elements(), before, {0.0, 1.0, 0.0}, {1.0, 0.0, 1.0}, nodes),
              (std::set<std::size_t>{2}));
    EXPECT_EQ(nodes[1], Vec3::Zero());
    EXPECT_EQ(nodes[4], Vec3::UnitX());
}

TEST(KeptChanges, GroupsThatGainStayWhole) {
    const std::vector<Vec3> before(5, Vec3::Zero());
    std::vector<Vec3> nodes(5, Vec3::Zero());
    nodes[0] = nodes[1] = Vec3::UnitY();
    EXPECT_EQ(revert_unhelpful_moves(elements(), before, {0.0, 0.0, -1.0}, {1.0, 0.0, -1.0}, nodes),
              (std::set<std::size_t>{0, 1}));
    EXPECT_EQ(nodes[0], Vec3::UnitY());
    EXPECT_TRUE(revert_unhelpful_moves(elements(), nodes, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, nodes).empty());
}

}  // namespace
}  // namespace mq::given

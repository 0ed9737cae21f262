// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/element_kind.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "elements/product/polynomial_map.h"

namespace mq::elements {
namespace {

TEST(ElementKind, NamesGoBothWays) {
    for (const ElementKind kind : kAllKinds) {
        EXPECT_EQ(element_kind(name_of(kind)), kind);
    }
    EXPECT_THROW(element_kind("wedge"), InvalidInput);
}

TEST(ElementKind, NodeCounts) {
    EXPECT_EQ(full_node_count(ElementKind::Triangle, 3), 10);
    EXPECT_EQ(full_node_count(ElementKind::Tetrahedron, 4), 35);
    EXPECT_EQ(full_node_count(ElementKind::Pyramid, 2), 14);
    EXPECT_EQ(full_node_count(ElementKind::Prism, 2), 18);
    EXPECT_EQ(full_node_count(ElementKind::Hexahedron, 5), 216);
    EXPECT_EQ(serendipity_node_count(ElementKind::Hexahedron, 2), 20);
    EXPECT_EQ(serendipity_node_count(ElementKind::Hexahedron, 3), 0);
    EXPECT_EQ(serendipity_node_count(ElementKind::Tetrahedron, 2), 0);
}

}  // namespace
}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/node_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "elements/bezier/simplex_lattice.h"
#include "elements/product/element_derivatives.h"
#include "elements/product/reference_nodes.h"

namespace mq::elements {
namespace {

TEST(NodeCells, FillTheElement) {
    const std::array<std::pair<ElementKind, double>, 4> volumes{{{ElementKind::Tetrahedron, 1.0 / 6.0},
                                                                 {ElementKind::Pyramid, 4.0 / 3.0},
                                                                 {ElementKind::Prism, 1.0},
                                                                 {ElementKind::Hexahedron, 8.0}}};
    for (const auto& [kind, volume] : volumes) {
        for (int order = 1; order <= kMaxOrder; ++order) {
            const std::vector<Vec3> nodes = reference_nodes(kind, order);
            double sum = 0.0;
            for (const std::array<int, 4>& cell : node_cells(kind, order)) {
                const auto at = [&](std::size_t i) { return nodes[static_cast<std::size_t>(cell[i])]; };
                const double part = (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) / 6.0;
                EXPECT_GT(std::abs(part), 1e-6) << name_of(kind) << order;
                sum += std::abs(part);
            }
            EXPECT_NEAR(sum, volume, 1e-12) << name_of(kind) << order;
        }
    }
    EXPECT_THROW(node_cells(ElementKind::Triangle, 1), InvalidInput);
    EXPECT_THROW(node_cells(ElementKind::Prism, 6), InvalidInput);
}

TEST(AllNodes, OfSerendipityElementsAreThoseOfTheStraightOne) {
    for (const ElementKind kind : {ElementKind::Pyramid, ElementKind::Prism, ElementKind::Hexahedron}) {
        const std::vector<Vec3> all = reference_nodes(kind, 2);
        const std::vector<Vec3> some(all.begin(), all.begin() + serendipity_node_count(kind, 2));
        const std::vector<Vec3> completed = all_nodes(kind, 2, some);
        ASSERT_EQ(completed.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_LT((completed[i] - all[i]).norm(), 1e-14) << name_of(kind) << i;
        }
    }
}

}  // namespace
}  // namespace mq::elements

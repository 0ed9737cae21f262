// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/transfinite_blending.h"

#include <gtest/gtest.h>

#include "elements/product/reference_nodes.h"

namespace mq::given {

using elements::ElementKind;

namespace {

/// Sets the nodes by a map, and expects the inner ones from the others.
template <typename Map>
void expect_reproduced(ElementKind kind, int order, const Map& map) {
    std::vector<Vec3> nodes;
    for (const Vec3& p : elements::reference_nodes(kind, order)) {
        nodes.push_back(map(p));
    }
    const std::vector<Vec3> wanted = nodes;
    for (const int i : Blending::of(kind, order).inner) {
        nodes[static_cast<std::size_t>(i)] = Vec3(9, 9, 9);
    }
    Blending::of(kind, order).apply(nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        EXPECT_NEAR((nodes[i] - wanted[i]).norm(), 0.0, 1e-9) << elements::name_of(kind) << " " << order << " " << i;
    }
}

TEST(InnerNodes, LinearMapsAreReproduced) {
    for (const ElementKind kind : {ElementKind::Triangle, ElementKind::Quadrilateral, ElementKind::Tetrahedron,
                                   ElementKind::Pyramid, ElementKind::Prism, ElementKind::Hexahedron}) {
        for (int order = 1; order <= 4; ++order) {
            expect_reproduced(kind, order,
                              [](const Vec3& p) { return Vec3(p.x() + 2 * p.y() - p.z() + 1, p.z() - p.x(), p.y()); });
        }
    }
}

TEST(InnerNodes, WhatIsLinearFromBottomToTopStaysSo) {
    for (const ElementKind kind : {ElementKind::Prism, ElementKind::Hexahedron}) {
        for (int order = 2; order <= 4; ++order) {
            expect_reproduced(kind, order, [](const Vec3& p) {
                return Vec3(p.x(), p.y(), p.z() + (1 - p.z()) * (p.x() * p.x() + 0.3 * p.x() * p.y()));
            });
        }
    }
}

}  // namespace
}  // namespace mq::given

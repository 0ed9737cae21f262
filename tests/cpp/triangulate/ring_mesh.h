// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Returns a polygon, counter-clockwise seen from above, with its corners joined to a point inside. The origins of
/// half-edges 0, 3, 6 ... are the corners, that of 2 is the point.
inline ClassifiedMesh ring_mesh(const std::vector<Vec3>& corners, const Vec3& inside) {
    ClassifiedMesh mesh;
    const Vec3 up(0, 0, 1);
    const int count = static_cast<int>(corners.size());
    std::vector<int> sites;
    std::vector<int> vertices;
    for (int i = 0; i < count; ++i) {
        const Vec3& p = corners[static_cast<std::size_t>(i)];
        vertices.push_back(mesh.add_vertex(p, {1, i}));
        sites.push_back(mesh.add_site({vertices.back(), p.head<2>(), up}));
    }
    const int middle = mesh.add_site({mesh.add_vertex(inside, {2, 0}), inside.head<2>(), up});
    for (int i = 0; i < count; ++i) {
        const int next = (i + 1) % count;
        const int t = mesh.add_triangle({sites[i], sites[next], middle}, 0);
        mesh.bind(3 * t, mesh.add_segment(i, {vertices[i], vertices[next]}, {0.0, 1.0}), i);
    }
    for (int i = 0; i < count; ++i) {
        mesh.link(3 * i + 1, 3 * ((i + 1) % count) + 2);
    }
    EXPECT_EQ(mesh.inconsistency(), "");
    return mesh;
}

}  // namespace mq::triangulate

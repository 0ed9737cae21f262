// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/surface/graded_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/predicates.h"
#include "wrap/boxes.h"
#include "wrap/outside/rolling_ball.h"
#include "wrap/outside/thin_material.h"
#include "wrap/surface/crossings.h"
#include "wrap/wrap.h"

namespace mq::wrap {
namespace {

using Face = std::array<Node, 3>;

/// The states of the nodes around some boxes, as wrap() determines them.
struct Wrapped {
    explicit Wrapped(const mesh::TriangleMesh& mesh, double gap = 1.5, double spacing = 0.5)
        : surface(mesh.vertices, mesh.triangles),
          radius(0.5 * gap + 0.5 * spacing),
          lattice(surface.tree.box(), radius + 2.0 * spacing, spacing),
          states(lattice, surface, radius, progress) {
        roll_ball(states, 0.5 * gap, progress);
        move_into_thin_material(states, progress);
        mark_sheets(states, progress);
    }

    Progress progress;
    InputSurface surface;
    double radius;
    Lattice lattice;
    NodeStates states;
};

/// Every crossed face of the tetrahedra has one on either side: together they fill the space around the wrap.
/// @return the number of tetrahedra by their longest edge along an axis, in half sides
std::map<std::int32_t, int> conforming_cells(const Wrapped& wrapped) {
    const GradedCells cells(wrapped.states, {}, wrapped.progress);
    std::map<Face, std::vector<int>> sides;
    std::map<std::int32_t, int> lengths;
    for (const std::array<std::int32_t, 3>& block : cells.blocks()) {
        cells.for_each_tetrahedron(block, [&](const std::array<Node, 4>& cell) {
            std::int32_t longest = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                Face face{cell[(k + 1) % 4], cell[(k + 2) % 4], cell[(k + 3) % 4]};
                std::sort(face.begin(), face.end());
                const auto at = [&](const Node& node) { return Vec3(node[0], node[1], node[2]); };
                const int side = orient3d(at(face[0]), at(face[1]), at(face[2]), at(cell[k]));
                EXPECT_NE(side, 0);
                sides[face].push_back(side);
                for (std::size_t i = 0; i < 3; ++i) {
                    longest = std::max(longest, std::abs(cell[k][i] - cell[(k + 1) % 4][i]));
                }
            }
            ++lengths[longest];
        });
    }
    const auto is_outside = [&](const Node& node) {
        return !wrapped.lattice.contains(node) || wrapped.states.is_outside(node);
    };
    for (const auto& [face, found] : sides) {
        EXPECT_LE(found.size(), 2U);
        if (found.size() == 2) {
            EXPECT_EQ(found[0] + found[1], 0);
        } else {
            EXPECT_EQ(is_outside(face[0]), is_outside(face[1]));
            EXPECT_EQ(is_outside(face[0]), is_outside(face[2]));
        }
    }
    return lengths;
}

TEST(GradedCells, FillTheSpaceAroundABox) {
    mesh::TriangleMesh mesh;
    test::add_box(mesh, {0, 0, 0}, {14, 12, 10});
    const std::map<std::int32_t, int> lengths = conforming_cells(Wrapped(mesh));
    for (const std::int32_t length : {2, 4, 8}) {
        EXPECT_GT(lengths.count(length), 0U) << length;
    }
}

TEST(GradedCells, FillTheSpaceWhereGapsAreClosedAndSheetsEnd) {
    mesh::TriangleMesh mesh;
    test::add_box(mesh, {0, 0, 0}, {9, 12, 10});
    test::add_box(mesh, {9.6, 0, 0}, {16, 11, 10}, 5);
    mesh.vertices.insert(mesh.vertices.end(), {{3, 3, 10}, {9, 4, 16}, {5, 9, 17}});
    mesh.triangles.push_back({16, 17, 18});
    conforming_cells(Wrapped(mesh));
}

TEST(GradedCells, PlaneFacesHaveFewCells) {
    mesh::TriangleMesh mesh;
    test::add_box(mesh, {0, 0, 0}, {40, 40, 6});
    Wrapped wrapped(mesh);
    const contour::CrossedCells cells = find_crossings(wrapped.states, {}, wrapped.progress);
    // Two faces of 80 x 80 sides: 12 cells or more at each square side of the lattice.
    EXPECT_LT(cells.cells.size(), 2U * 80U * 80U * 12U / 2U);
    for (const contour::Crossing& crossing : cells.crossings) {
        EXPECT_GE(crossing.source, 0);
    }
}

TEST(GradedCells, BordersBetweenPatchesOfOnePlaneStay) {
    mesh::TriangleMesh mesh;
    test::add_box(mesh, {0, 0, 0}, {10.3, 16, 6});
    test::add_box(mesh, {10.3, 0, 0}, {20, 16, 6});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        mesh.triangle_face.push_back(static_cast<std::int32_t>(t / 2));
    }
    WrapOptions options;
    options.gap = 1.5;
    options.spacing = 0.5;
    Progress progress;
    const WrapResult result = wrap(mesh, options, progress);
    int above = 0;
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        const std::int32_t face = result.triangle_source[t] / 2;
        if (face != 1 && face != 7) {  // the tops of both
            continue;
        }
        ++above;
        for (const std::int32_t v : result.mesh.triangles[t]) {
            const double x = result.mesh.vertices[static_cast<std::size_t>(v)].x();
            EXPECT_TRUE(face == 1 ? x < 10.3 + options.spacing : x > 10.3 - options.spacing) << x;
        }
    }
    EXPECT_GT(above, 0);
}

}  // namespace
}  // namespace mq::wrap

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/candidate_edges.h"

#include <gtest/gtest.h>

#include "curve/elements.h"
#include "elements/bezier/jacobian.h"

namespace mq::elements {

using curve::identity;

namespace {

/// The edges of a tetrahedron by their corners.
constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

std::vector<Vec3> with_edge_moved(std::size_t edge, const Vec3& by) {
    const Lattice& lattice = Lattice::of(3, 2);
    std::vector<Vec3> nodes = curve::nodes_of(lattice, identity);
    Exponents e{};
    e[kEdges[edge][0]] = 1;
    e[kEdges[edge][1]] = 1;
    nodes[static_cast<std::size_t>(lattice.index(e))] += by;
    return nodes_to_bezier(lattice, nodes);
}

/// Properties 1 and 2 of section 5.2: the control points on which J at a corner and on an edge does not depend.
TEST(Locality, JAtACornerDependsOnItsEdgesOnly) {
    const Lattice& lattice = Lattice::of(3, 2);
    for (std::size_t edge = 0; edge < 6; ++edge) {
        const std::vector<Vec3> control = with_edge_moved(edge, Vec3(0.1, 0.07, 0.05));
        for (std::size_t k = 0; k < 4; ++k) {
            Barycentric at{};
            at[k] = 1.0;
            const bool there = kEdges[edge][0] == k || kEdges[edge][1] == k;
            EXPECT_EQ(std::abs(jacobian_at(lattice, control, at) - 1.0) > 1e-9, there);
        }
        for (std::size_t other = 0; other < 6; ++other) {
            Barycentric at{};
            at[kEdges[other][0]] = 0.3;
            at[kEdges[other][1]] = 0.7;
            const bool opposite = other + edge == 5;
            EXPECT_EQ(std::abs(jacobian_at(lattice, control, at) - 1.0) < 1e-9, opposite);
        }
    }
}

TEST(Locality, AValidElementHasNoCandidates) {
    const CandidateEdges marks = candidate_edges(Lattice::of(3, 2), with_edge_moved(0, Vec3(0.0, 0.05, 0.0)));
    EXPECT_EQ(std::count(marks.begin(), marks.end(), true), 0);
}

TEST(Locality, ABadCornerBlamesItsThreeEdges) {
    // The tangent of edge (0, 1) at corner 0 turns backwards; everywhere else J stays positive.
    const Lattice& lattice = Lattice::of(3, 3);
    std::vector<Vec3> control = nodes_to_bezier(lattice, curve::nodes_of(lattice, identity));
    control[static_cast<std::size_t>(lattice.index({2, 1, 0, 0}))] = Vec3(-0.01, 0.0, 0.0);
    const CandidateEdges marks = candidate_edges(lattice, control);
    const CandidateEdges expected{true, true, true, false, false, false};
    EXPECT_EQ(marks, expected);
}

TEST(Locality, ABadInsideBlamesAll) {
    const CandidateEdges marks = candidate_edges(Lattice::of(3, 2), with_edge_moved(0, Vec3(0.0, 1.0, 1.0)));
    EXPECT_EQ(std::count(marks.begin(), marks.end(), true), 6);
}

}  // namespace
}  // namespace mq::elements

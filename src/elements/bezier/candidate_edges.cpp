// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/candidate_edges.h"

#include "elements/bezier/jacobian.h"

namespace mq::elements {

namespace {

/// The edges of a tetrahedron by their corners, in the order of CandidateEdges.
constexpr std::array<std::array<int, 2>, 6> kEdges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Marks the edges with an end among the corners whose bits are set.
void mark(CandidateEdges& marks, unsigned corners) {
    for (std::size_t i = 0; i < kEdges.size(); ++i) {
        marks[i] = marks[i] || ((corners >> kEdges[i][0]) & 1u) != 0 || ((corners >> kEdges[i][1]) & 1u) != 0;
    }
}

/// The middle of the sub-simplex whose corners' bits are set.
Barycentric middle_of(unsigned corners) {
    Barycentric at{};
    double count = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        at[k] = (corners >> k) & 1u;
        count += at[k];
    }
    for (double& part : at) {
        part /= count;
    }
    return at;
}

}  // namespace

CandidateEdges candidate_edges(const Lattice& lattice, const std::vector<Vec3>& control) {
    CandidateEdges marks{};
    // Every set of corners is a corner, an edge, a face or the element; three corners or more touch all edges.
    for (unsigned corners = 1; corners < 16; ++corners) {
        if (!(jacobian_at(lattice, control, middle_of(corners)) > 0.0)) {
            mark(marks, corners);
        }
    }
    return marks;
}

}  // namespace mq::elements

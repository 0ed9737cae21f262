// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/node_orders.h"

#include <algorithm>

#include "base/memory/never_destroyed.h"

namespace mq::curve {

namespace {

using Corners = std::vector<Exponents>;

/// How a format lists the edges of a triangle and of a tetrahedron, and the faces.
struct Convention {
    std::vector<std::array<int, 2>> edges;
    std::vector<std::array<int, 3>> faces;
};

const Convention& gmsh_convention() {
    static const auto& convention = never_destroyed<Convention>(
        {{{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {3, 1, 2}}});
    return convention;
}

const Convention& vtk_convention() {
    static const auto& convention = never_destroyed<Convention>(
        {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}, {{0, 1, 3}, {2, 3, 1}, {0, 3, 2}, {0, 2, 1}}});
    return convention;
}

Exponents moved(const Exponents& from, const Exponents& to, int step, int steps) {
    Exponents e{};
    for (std::size_t k = 0; k < 4; ++k) {
        e[k] = from[k] + (to[k] - from[k]) / steps * step;
    }
    return e;
}

void append_edge(const Exponents& a, const Exponents& b, int order, std::vector<Exponents>& out) {
    for (int i = 1; i < order; ++i) {
        out.push_back(moved(a, b, i, order));
    }
}

/// The corners of the lattice of points strictly inside a simplex: one step in along every edge.
Corners inside(const Corners& corners, int order) {
    Corners result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Exponents e = corners[i];
        for (std::size_t j = 0; j < corners.size(); ++j) {
            const Exponents step = moved(corners[i], corners[j], 1, order);
            for (std::size_t k = 0; k < 4; ++k) {
                e[k] += j == i ? 0 : step[k] - corners[i][k];
            }
        }
        result.push_back(e);
    }
    return result;
}

void append(const Corners& corners, int order, const Convention& convention, std::vector<Exponents>& out) {
    const std::size_t dimension = corners.size() - 1;
    if (order == 0) {
        out.push_back(corners[0]);
        return;
    }
    out.insert(out.end(), corners.begin(), corners.end());
    if (order == 1) {
        return;
    }
    const std::size_t edges = dimension == 1 ? 1 : dimension == 2 ? 3 : 6;
    for (std::size_t i = 0; i < edges; ++i) {
        const auto& edge = convention.edges[i];
        append_edge(corners[static_cast<std::size_t>(edge[0])], corners[static_cast<std::size_t>(edge[1])], order, out);
    }
    if (dimension == 3 && order > 2) {
        for (const auto& face : convention.faces) {
            const Corners three{corners[static_cast<std::size_t>(face[0])], corners[static_cast<std::size_t>(face[1])],
                                corners[static_cast<std::size_t>(face[2])]};
            append(inside(three, order), order - 3, convention, out);
        }
    }
    const int within = static_cast<int>(dimension) + 1;
    if (dimension >= 2 && order >= within) {
        append(inside(corners, order), order - within, convention, out);
    }
}

std::vector<int> order_of(const Lattice& lattice, const Convention& convention) {
    Corners corners;
    for (int k = 0; k <= lattice.dimension(); ++k) {
        corners.push_back(lattice.exponents(lattice.corner(k)));
    }
    std::vector<Exponents> points;
    append(corners, lattice.degree(), convention, points);
    std::vector<int> result;
    for (const Exponents& e : points) {
        result.push_back(lattice.index(e));
    }
    return result;
}

}  // namespace

std::vector<int> gmsh_order(const Lattice& lattice) {
    return order_of(lattice, gmsh_convention());
}

std::vector<int> vtk_order(const Lattice& lattice) {
    return order_of(lattice, vtk_convention());
}

}  // namespace mq::curve

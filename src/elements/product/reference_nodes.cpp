// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/reference_nodes.h"

#include <string>

#include "base/error.h"
#include "base/memory/never_destroyed.h"
#include "elements/bezier/node_orders.h"

namespace mq::curve {

namespace {

using Points = std::vector<GridPoint>;

Points corners_of(ElementKind kind, int n) {
    switch (kind) {
        case ElementKind::Triangle:
            return {{0, 0, 0}, {n, 0, 0}, {0, n, 0}};
        case ElementKind::Quadrilateral:
            return {{0, 0, 0}, {n, 0, 0}, {n, n, 0}, {0, n, 0}};
        case ElementKind::Tetrahedron:
            return {{0, 0, 0}, {n, 0, 0}, {0, n, 0}, {0, 0, n}};
        case ElementKind::Pyramid:
            return {{-n, -n, 0}, {n, -n, 0}, {n, n, 0}, {-n, n, 0}, {0, 0, n}};
        case ElementKind::Prism:
            return {{0, 0, 0}, {n, 0, 0}, {0, n, 0}, {0, 0, n}, {n, 0, n}, {0, n, n}};
        case ElementKind::Hexahedron:
            break;
    }
    return {{0, 0, 0}, {n, 0, 0}, {n, n, 0}, {0, n, 0}, {0, 0, n}, {n, 0, n}, {n, n, n}, {0, n, n}};
}

/// The point `step` of `steps` along the way.
GridPoint along(const GridPoint& from, const GridPoint& to, int step, int steps) {
    GridPoint p{};
    for (std::size_t k = 0; k < 3; ++k) {
        p[k] = from[k] + (to[k] - from[k]) / steps * step;
    }
    return p;
}

/// The corner moved inwards by one of `steps` towards each of its neighbours.
GridPoint inwards(const GridPoint& corner, const Points& neighbours, int steps) {
    GridPoint p = corner;
    for (const GridPoint& neighbour : neighbours) {
        const GridPoint q = along(corner, neighbour, 1, steps);
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] += q[k] - corner[k];
        }
    }
    return p;
}

void append_edge(const GridPoint& from, const GridPoint& to, int order, Points& out) {
    for (int i = 1; i < order; ++i) {
        out.push_back(along(from, to, i, order));
    }
}

/// A triangle or tetrahedron on these corners.
void append_simplex(const Points& corners, int order, Points& out) {
    if (order == 0) {
        out.push_back(corners[0]);
        return;
    }
    const Lattice& lattice = Lattice::of(static_cast<int>(corners.size()) - 1, order);
    for (const int i : gmsh_order(lattice)) {
        GridPoint p{};
        for (std::size_t c = 0; c < corners.size(); ++c) {
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] += lattice.exponents(i)[c] * corners[c][k];
            }
        }
        for (int& coordinate : p) {
            coordinate /= order;
        }
        out.push_back(p);
    }
}

void append_quadrilateral(const Points& corners, int order, Points& out);

/// The nodes within a face of three or four corners.
void append_within_face(const Points& corners, int order, Points& out) {
    const std::size_t n = corners.size();
    const int inner = order - (n == 3 ? 3 : 2);
    if (inner < 0) {
        return;
    }
    Points inside;
    for (std::size_t i = 0; i < n; ++i) {
        inside.push_back(inwards(corners[i], {corners[(i + 1) % n], corners[(i + n - 1) % n]}, order));
    }
    if (n == 3) {
        append_simplex(inside, inner, out);
    } else {
        append_quadrilateral(inside, inner, out);
    }
}

void append_quadrilateral(const Points& corners, int order, Points& out) {
    if (order == 0) {
        out.push_back(corners[0]);
        return;
    }
    out.insert(out.end(), corners.begin(), corners.end());
    for (std::size_t i = 0; i < 4; ++i) {
        append_edge(corners[i], corners[(i + 1) % 4], order, out);
    }
    append_within_face(corners, order, out);
}

void append_solid(ElementKind kind, const Points& corners, int order, Points& out);

void append_within_prism(const Points& corners, int order, Points& out) {
    if (order < 3) {
        return;
    }
    // Lines over the nodes inside of the triangle; the ends of each line come first.
    Points base;
    append_within_face({corners[0], corners[1], corners[2]}, order, base);
    const GridPoint rise{0, 0, corners[3][2] - corners[0][2]};
    for (const GridPoint& p : base) {
        const GridPoint top{p[0] + rise[0], p[1] + rise[1], p[2] + rise[2]};
        Points line;
        append_edge(p, top, order, line);
        out.push_back(line.front());
        out.push_back(line.back());
        out.insert(out.end(), line.begin() + 1, line.end() - 1);
    }
}

void append_within_pyramid(const Points& corners, int order, Points& out) {
    if (order < 3) {
        return;
    }
    Points inside;
    for (std::size_t i = 0; i < 4; ++i) {
        inside.push_back(inwards(corners[i], {corners[(i + 1) % 4], corners[(i + 3) % 4], corners[4]}, order));
    }
    inside.push_back(inwards(corners[4], {corners[0], corners[2]}, order));
    append_solid(ElementKind::Pyramid, inside, order - 3, out);
}

void append_within_hexahedron(const Points& corners, int order, Points& out) {
    if (order < 2) {
        return;
    }
    Points inside;
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t level = i / 4 * 4;
        inside.push_back(inwards(
            corners[i], {corners[level + (i + 1) % 4], corners[level + (i + 3) % 4], corners[(i + 4) % 8]}, order));
    }
    append_solid(ElementKind::Hexahedron, inside, order - 2, out);
}

void append_solid(ElementKind kind, const Points& corners, int order, Points& out) {
    if (order == 0) {
        out.push_back(corners[0]);
        return;
    }
    const ElementSides& by = sides_of(kind);
    out.insert(out.end(), corners.begin(), corners.end());
    for (const auto& edge : by.edges) {
        append_edge(corners[edge[0]], corners[edge[1]], order, out);
    }
    for (const auto& face : by.faces) {
        Points on;
        for (const std::size_t corner : face) {
            on.push_back(corners[corner]);
        }
        append_within_face(on, order, out);
    }
    if (kind == ElementKind::Prism) {
        append_within_prism(corners, order, out);
    } else if (kind == ElementKind::Pyramid) {
        append_within_pyramid(corners, order, out);
    } else {
        append_within_hexahedron(corners, order, out);
    }
}

}  // namespace

const ElementSides& sides_of(ElementKind kind) {
    static const auto& sides = never_destroyed<std::array<ElementSides, 6>>({{
        {{{0, 1}, {1, 2}, {2, 0}}, {{0, 1, 2}}},
        {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {{0, 1, 2, 3}}},
        {{{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {3, 1, 2}}},
        {{{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}},
         {{0, 1, 4}, {3, 0, 4}, {1, 2, 4}, {2, 3, 4}, {0, 3, 2, 1}}},
        {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}},
         {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {0, 3, 5, 2}, {1, 2, 5, 4}}},
        {{{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}},
         {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}}},
    }});
    return sides[static_cast<std::size_t>(kind)];
}

std::vector<GridPoint> gmsh_nodes(ElementKind kind, int order) {
    if (order < 1 || order > kMaxOrder) {
        throw InvalidInput("elements have an order of 1 to " + std::to_string(kMaxOrder) + ", not " +
                           std::to_string(order));
    }
    const Points corners = corners_of(kind, order);
    Points nodes;
    if (kind == ElementKind::Triangle || kind == ElementKind::Tetrahedron) {
        append_simplex(corners, order, nodes);
    } else if (kind == ElementKind::Quadrilateral) {
        append_quadrilateral(corners, order, nodes);
    } else {
        append_solid(kind, corners, order, nodes);
    }
    return nodes;
}

std::vector<Vec3> reference_nodes(ElementKind kind, int order) {
    std::vector<Vec3> places;
    for (const GridPoint& point : gmsh_nodes(kind, order)) {
        const Vec3 unit = Vec3(point[0], point[1], point[2]) / order;
        switch (kind) {
            case ElementKind::Quadrilateral:
                places.emplace_back(2.0 * unit.x() - 1.0, 2.0 * unit.y() - 1.0, 0.0);
                break;
            case ElementKind::Prism:
                places.emplace_back(unit.x(), unit.y(), 2.0 * unit.z() - 1.0);
                break;
            case ElementKind::Hexahedron:
                places.emplace_back(2.0 * unit - Vec3::Ones());
                break;
            case ElementKind::Triangle:
            case ElementKind::Tetrahedron:
            case ElementKind::Pyramid:
                places.push_back(unit);
                break;
        }
    }
    return places;
}

}  // namespace mq::curve

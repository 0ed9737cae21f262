// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/reference_nodes.h"

#include "base/error.h"
#include "base/memory/never_destroyed.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/bezier/bernstein.h"

namespace mq::elements {

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

/// Point `step` of the division of the segment into `steps` pieces.
GridPoint along(const GridPoint& from, const GridPoint& to, int step, int steps) {
    GridPoint p{};
    for (std::size_t k = 0; k < 3; ++k) {
        p[k] = from[k] + (to[k] - from[k]) / steps * step;
    }
    return p;
}

/// Corners whose mean is the centre of an element; none for prisms. The inner nodes form an element whose order is
/// lower by the number of these corners.
const std::vector<std::size_t>& central_corners(ElementKind kind) {
    static const auto& corners = never_destroyed<std::array<std::vector<std::size_t>, 6>>(
        {{{0, 1, 2}, {0, 2}, {0, 1, 2, 3}, {0, 2, 4}, {}, {0, 6}}});
    return corners[static_cast<std::size_t>(kind)];
}

void append(ElementKind kind, const ElementSides& by, const Points& corners, int order, Points& out);

/// The nodes inside of an element, edges and faces apart.
void append_inside(ElementKind kind, const ElementSides& by, const Points& corners, int order, Points& out) {
    if (kind == ElementKind::Prism) {
        // Lines over the nodes inside of the triangle; the ends of each line come first.
        Points base;
        append_inside(ElementKind::Triangle, sides_of(ElementKind::Triangle), {corners[0], corners[1], corners[2]},
                      order, base);
        for (GridPoint p : base) {
            const int foot = p[2];
            for (int i = 1; i < order; ++i) {
                const int step = i == 1 ? 1 : i == 2 ? order - 1 : i - 1;
                p[2] = foot + (corners[3][2] - corners[0][2]) / order * step;
                out.push_back(p);
            }
        }
        return;
    }
    const std::vector<std::size_t>& central = central_corners(kind);
    const int inner = order - static_cast<int>(central.size());
    if (inner < 0) {
        return;
    }
    Points inside = corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (const std::size_t c : central) {
            const GridPoint towards = along(corners[i], corners[c], 1, order);
            for (std::size_t k = 0; k < 3; ++k) {
                inside[i][k] += towards[k] - corners[i][k];
            }
        }
    }
    append(kind, by, inside, inner, out);
}

/// The nodes of an element with these corners: corners, edges, faces, and then the inside.
void append(ElementKind kind, const ElementSides& by, const Points& corners, int order, Points& out) {
    if (order == 0) {
        out.push_back(corners[0]);
        return;
    }
    out.insert(out.end(), corners.begin(), corners.end());
    for (const auto& [a, b] : by.edges) {
        for (int i = 1; i < order; ++i) {
            out.push_back(along(corners[a], corners[b], i, order));
        }
    }
    if (dimension_of(kind) == 3) {
        for (const auto& face : by.faces) {
            const ElementKind flat = face.size() == 3 ? ElementKind::Triangle : ElementKind::Quadrilateral;
            Points on;
            for (const std::size_t corner : face) {
                on.push_back(corners[corner]);
            }
            append_inside(flat, sides_of(flat), on, order, out);
        }
    }
    append_inside(kind, by, corners, order, out);
}

/// The indices of a simplex' nodes, with its sides in the order of a format; those of a line are on the first edge of a
/// triangle.
std::vector<int> order_of(const Lattice& lattice, const ElementSides& tetrahedron) {
    const ElementKind kind = lattice.dimension() == 3 ? ElementKind::Tetrahedron : ElementKind::Triangle;
    Points nodes;
    append(kind, lattice.dimension() == 3 ? tetrahedron : sides_of(kind), corners_of(kind, lattice.degree()),
           lattice.degree(), nodes);
    std::vector<int> result;
    for (const auto& [x, y, z] : nodes) {
        if (lattice.dimension() > 1 || y == 0) {
            result.push_back(lattice.index({lattice.degree() - x - y - z, x, y, z}));
        }
    }
    return result;
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
        throw InvalidInput(phrases::kElementOrder, {{"count", kMaxOrder}, {"count2", order}});
    }
    Points nodes;
    append(kind, sides_of(kind), corners_of(kind, order), order, nodes);
    return nodes;
}

const std::vector<int>& gmsh_order(const Lattice& lattice) {
    static const auto& all = never_destroyed([] {
        std::vector<std::vector<int>> orders;
        for (int dimension = 1; dimension <= 3; ++dimension) {
            for (int degree = 0; degree <= kMaxDegree; ++degree) {
                orders.push_back(order_of(Lattice::of(dimension, degree), sides_of(ElementKind::Tetrahedron)));
            }
        }
        return orders;
    }());
    return all[static_cast<std::size_t>((lattice.dimension() - 1) * (kMaxDegree + 1) + lattice.degree())];
}

std::vector<Vec3> gmsh_to_bezier(const Lattice& lattice, const std::vector<Vec3>& nodes) {
    const std::vector<int>& order = gmsh_order(lattice);
    std::vector<Vec3> in_lattice(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        in_lattice[static_cast<std::size_t>(order[i])] = nodes[i];
    }
    return nodes_to_bezier(lattice, in_lattice);
}

std::vector<Vec3> bezier_to_gmsh(const Lattice& lattice, const std::vector<Vec3>& control) {
    const std::vector<Vec3> in_lattice = bezier_to_nodes(lattice, control);
    std::vector<Vec3> nodes;
    for (const int i : gmsh_order(lattice)) {
        nodes.push_back(in_lattice[static_cast<std::size_t>(i)]);
    }
    return nodes;
}

std::vector<int> vtk_order(const Lattice& lattice) {
    static const auto& sides = never_destroyed<ElementSides>(
        {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}, {{0, 1, 3}, {2, 3, 1}, {0, 3, 2}, {0, 2, 1}}});
    return order_of(lattice, sides);
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

}  // namespace mq::elements

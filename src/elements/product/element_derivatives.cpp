// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/element_derivatives.h"

#include <Eigen/LU>
#include <algorithm>
#include <string>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/bezier/bernstein.h"
#include "elements/product/reference_nodes.h"

namespace mq::elements {

namespace {

using Factor = ProductLattice::Factor;

std::vector<Factor> factors_of(ElementKind kind, int order) {
    switch (kind) {
        case ElementKind::Triangle:
            return {{2, order}};
        case ElementKind::Quadrilateral:
            return {{1, order}, {1, order}};
        case ElementKind::Tetrahedron:
            return {{3, order}};
        case ElementKind::Prism:
            return {{2, order}, {1, order}};
        case ElementKind::Pyramid:
        case ElementKind::Hexahedron:
            break;
    }
    return {{1, order}, {1, order}, {1, order}};
}

int corner_count(ElementKind kind) {
    return full_node_count(kind, 1);
}

/// Weights of the given nodes for all nodes of the full element, in Gmsh's order.
///
/// The missing nodes are the middles of faces and of hexahedra. A serendipity polynomial has no term of degree 2 along
/// more than one axis: its value in a middle is the sum over the nodes symmetric about it, with weights of -1/4 for
/// corners and equal weights for edge nodes, all adding up to 1.
ExtendedMatrix completion(const std::vector<GridPoint>& points, int corners, int given) {
    const auto all = static_cast<int>(points.size());
    ExtendedMatrix weights = ExtendedMatrix::Zero(all, given);
    for (int i = 0; i < given; ++i) {
        weights(i, i) = 1.0L;
    }
    for (int i = given; i < all; ++i) {
        std::vector<int> symmetric;
        for (int j = 0; j < given; ++j) {
            GridPoint opposite{};
            for (std::size_t k = 0; k < 3; ++k) {
                opposite[k] = 2 * points[static_cast<std::size_t>(i)][k] - points[static_cast<std::size_t>(j)][k];
            }
            if (std::find(points.begin(), points.begin() + given, opposite) != points.begin() + given) {
                symmetric.push_back(j);
            }
        }
        const auto of_corners = std::count_if(symmetric.begin(), symmetric.end(), [&](int j) { return j < corners; });
        const auto of_edges = static_cast<long double>(static_cast<std::ptrdiff_t>(symmetric.size()) - of_corners);
        for (const int j : symmetric) {
            weights(i, j) = j < corners ? -0.25L : (1.0L + 0.25L * static_cast<long double>(of_corners)) / of_edges;
        }
    }
    return weights;
}

/// The Bezier control points on a product of simplices.
NodalPolynomial map_of(ElementKind kind, int order, const std::vector<GridPoint>& points,
                       const ExtendedMatrix& weights) {
    NodalPolynomial map{ProductLattice(factors_of(kind, order)), {}};
    const ProductLattice& lattice = map.lattice;
    ExtendedMatrix from_points(lattice.size(), weights.rows());
    for (std::size_t g = 0; g < points.size(); ++g) {
        // The node's index in the lattice of each factor.
        ProductLattice::Indices node{};
        std::size_t axis = 0;
        for (int f = 0; f < lattice.factors(); ++f) {
            Exponents e{order, 0, 0, 0};
            for (std::size_t k = 1; k <= static_cast<std::size_t>(lattice.factor(f).dimension()); ++k) {
                e[k] = points[g][axis++];
                e[0] -= e[k];
            }
            node[static_cast<std::size_t>(f)] = lattice.factor(f).index(e);
        }
        for (int i = 0; i < lattice.size(); ++i) {
            const ProductLattice::Indices at = lattice.indices(i);
            long double weight = 1.0L;
            for (int f = 0; f < lattice.factors(); ++f) {
                const auto k = static_cast<std::size_t>(f);
                weight *= static_cast<long double>(nodes_to_bezier_matrix(lattice.factor(f))(at[k], node[k]));
            }
            from_points(i, static_cast<Eigen::Index>(g)) = weight;
        }
    }
    map.from_nodes = from_points * weights;
    return map;
}

/// The derivative along the edge from corner 0 to corner `k` of factor `f`.
NodalPolynomial derivative(const NodalPolynomial& map, int f, int k) {
    NodalPolynomial result{ProductLattice(map.lattice.lowered(f)), {}};
    const Lattice& full = map.lattice.factor(f);
    const auto at_factor = static_cast<std::size_t>(f);
    result.from_nodes.resize(result.lattice.size(), map.from_nodes.cols());
    for (int i = 0; i < result.lattice.size(); ++i) {
        ProductLattice::Indices from = result.lattice.indices(i);
        ProductLattice::Indices to = from;
        Exponents e = result.lattice.factor(f).exponents(from[at_factor]);
        ++e[0];
        from[at_factor] = full.index(e);
        --e[0];
        ++e[static_cast<std::size_t>(k)];
        to[at_factor] = full.index(e);
        result.from_nodes.row(i) =
            full.degree() * (map.from_nodes.row(map.lattice.index(to)) - map.from_nodes.row(map.lattice.index(from)));
    }
    return result;
}

long double binomial(int n, int k) {
    return Lattice::of(1, n).multinomial(k);
}

long double power(long double base, int exponent) {
    long double result = 1.0L;
    for (int i = 0; i < exponent; ++i) {
        result *= base;
    }
    return result;
}

long double bernstein(int i, int degree, long double t) {
    return binomial(degree, i) * power(t, i) * power(1.0L - t, degree - i);
}

/// Weight of coefficient j of degree `from` for coefficient i of the same polynomial at degree `to`.
long double elevation(int from, int j, int to, int i) {
    return i < j || i - j > to - from ? 0.0L : binomial(from, j) * binomial(to - from, i - j) / binomial(to, i);
}

/// The control points of a pyramid on its levels: k from 0 at the base to the order at the apex, each a square of
/// (p - k + 1)^2 of them.
class PyramidLevels {
  public:
    PyramidLevels(int order, const std::vector<GridPoint>& points, const ExtendedMatrix& weights) : order_(order) {
        const auto n = static_cast<Eigen::Index>(points.size());
        ExtendedMatrix values(n, n);
        for (Eigen::Index g = 0; g < n; ++g) {
            const GridPoint& p = points[static_cast<std::size_t>(g)];
            const long double z = static_cast<long double>(p[2]) / order;
            const int side = order - p[2];
            const long double u = side > 0 ? 0.5L * static_cast<long double>(p[0] + side) / side : 0.0L;
            const long double v = side > 0 ? 0.5L * static_cast<long double>(p[1] + side) / side : 0.0L;
            for (int k = 0; k <= order; ++k) {
                for (int a = 0; a <= order - k; ++a) {
                    for (int b = 0; b <= order - k; ++b) {
                        values(g, row(k, a, b)) =
                            bernstein(k, order, z) * bernstein(a, order - k, u) * bernstein(b, order - k, v);
                    }
                }
            }
        }
        control_ = values.fullPivLu().inverse() * weights;
    }

    /// Derivative by u (axis 0) or v (axis 1), divided by 1 - z.
    NodalPolynomial across(int axis) const {
        const int p = order_;
        NodalPolynomial result{ProductLattice({{1, axis == 0 ? p - 1 : p}, {1, axis == 1 ? p - 1 : p}, {1, p - 1}}),
                               {}};
        result.from_nodes = ExtendedMatrix::Zero(result.lattice.size(), control_.cols());
        for (int i = 0; i < result.lattice.size(); ++i) {
            const auto [iu, iv, k] = result.lattice.indices(i);
            const int du = axis == 0 ? 1 : 0;
            for (int a = 0; a <= p - k - du; ++a) {
                for (int b = 0; b <= p - k - (1 - du); ++b) {
                    const long double weight =
                        elevation(p - k - du, a, p - du, iu) * elevation(p - k - (1 - du), b, p - (1 - du), iv);
                    result.from_nodes.row(i) +=
                        weight * p * (control_.row(row(k, a + du, b + 1 - du)) - control_.row(row(k, a, b)));
                }
            }
        }
        return result;
    }

    /// Derivative by z with u and v fixed.
    NodalPolynomial upwards() const {
        const int p = order_;
        NodalPolynomial result{ProductLattice({{1, p}, {1, p}, {1, p - 1}}), {}};
        result.from_nodes.resize(result.lattice.size(), control_.cols());
        for (int i = 0; i < result.lattice.size(); ++i) {
            const auto [iu, iv, k] = result.lattice.indices(i);
            result.from_nodes.row(i) = p * (elevated(k + 1, iu, iv) - elevated(k, iu, iv));
        }
        return result;
    }

  private:
    Eigen::Index row(int k, int a, int b) const {
        Eigen::Index before = 0;
        for (int level = 0; level < k; ++level) {
            before += static_cast<Eigen::Index>(order_ - level + 1) * (order_ - level + 1);
        }
        return before + static_cast<Eigen::Index>(a) * (order_ - k + 1) + b;
    }

    /// Coefficient (iu, iv) of level k at the degree of the base.
    ExtendedMatrix elevated(int k, int iu, int iv) const {
        ExtendedMatrix sum = ExtendedMatrix::Zero(1, control_.cols());
        for (int a = 0; a <= order_ - k; ++a) {
            for (int b = 0; b <= order_ - k; ++b) {
                sum += elevation(order_ - k, a, order_, iu) * elevation(order_ - k, b, order_, iv) *
                       control_.row(row(k, a, b));
            }
        }
        return sum;
    }

    int order_;
    ExtendedMatrix control_;
};

void require_node_count(ElementKind kind, int order, int nodes) {
    const int full = full_node_count(kind, order);
    const int fewer = serendipity_node_count(kind, order);
    if (nodes != full && (nodes != fewer || fewer == 0)) {
        throw InvalidInput(fewer > 0 ? phrases::kNodeCounts : phrases::kNodeCount,
                           {{"kind", std::string(name_of(kind))},
                            {"count", order},
                            {"count2", full},
                            {"count3", nodes},
                            {"count4", fewer}});
    }
}

}  // namespace

std::vector<NodalPolynomial> derivatives_of(ElementKind kind, int order, int nodes) {
    const std::vector<GridPoint> points = gmsh_nodes(kind, order);
    require_node_count(kind, order, nodes);
    const ExtendedMatrix weights = completion(points, corner_count(kind), nodes);
    if (kind == ElementKind::Pyramid) {
        const PyramidLevels levels(order, points, weights);
        return {levels.across(0), levels.across(1), levels.upwards()};
    }
    const NodalPolynomial map = map_of(kind, order, points, weights);
    std::vector<NodalPolynomial> result;
    for (int f = 0; f < map.lattice.factors(); ++f) {
        for (int k = 1; k <= map.lattice.factor(f).dimension(); ++k) {
            result.push_back(derivative(map, f, k));
        }
    }
    return result;
}

std::vector<Vec3> all_nodes(ElementKind kind, int order, const std::vector<Vec3>& nodes) {
    require_node_count(kind, order, static_cast<int>(nodes.size()));
    std::vector<Vec3> all = nodes;
    if (static_cast<int>(nodes.size()) == full_node_count(kind, order)) {
        return all;
    }
    const std::vector<GridPoint> points = gmsh_nodes(kind, order);
    const ExtendedMatrix weights = completion(points, corner_count(kind), static_cast<int>(nodes.size()));
    for (auto i = static_cast<Eigen::Index>(nodes.size()); i < weights.rows(); ++i) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            sum += static_cast<double>(weights(i, static_cast<Eigen::Index>(j))) * nodes[j];
        }
        all.push_back(sum);
    }
    return all;
}

}  // namespace mq::elements

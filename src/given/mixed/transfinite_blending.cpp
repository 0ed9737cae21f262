// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/transfinite_blending.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "base/memory/never_destroyed.h"
#include "elements/bezier/blending.h"
#include "elements/product/reference_nodes.h"
#include "given/mixed/node_table.h"

namespace mq::given {

using elements::ElementKind;
using elements::GridPoint;

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Sets the nodes inside of triangles and tetrahedra by their control points.
void blend_simplex(int dimension, int order, std::vector<Vec3>& nodes) {
    const elements::Lattice& lattice = elements::Lattice::of(dimension, order);
    std::vector<Vec3> control = elements::gmsh_to_bezier(lattice, nodes);
    if (dimension == 2) {
        elements::blend_triangle(lattice, control);
    } else {
        elements::blend_tetrahedron(lattice, control);
    }
    nodes = elements::bezier_to_gmsh(lattice, control);
}

/// A square of (n + 1)^2 values whose inner values are blended from those on its sides (Coons 1967).
class Square {
  public:
    explicit Square(int n) : n_(n), values_(at((n + 1) * (n + 1)), Vec3::Zero()) {}

    Vec3& operator()(int i, int j) { return values_[at(i * (n_ + 1) + j)]; }
    void blend() {
        for (int i = 1; i < n_; ++i) {
            for (int j = 1; j < n_; ++j) {
                const double u = static_cast<double>(i) / n_;
                const double v = static_cast<double>(j) / n_;
                Square& c = *this;
                c(i, j) = (1.0 - v) * c(i, 0) + v * c(i, n_) + (1.0 - u) * c(0, j) + u * c(n_, j) -
                          (1.0 - u) * ((1.0 - v) * c(0, 0) + v * c(0, n_)) - u * ((1.0 - v) * c(n_, 0) + v * c(n_, n_));
            }
        }
    }

  private:
    int n_;
    std::vector<Vec3> values_;
};

/// By point of the grid: the node in Gmsh's order.
std::map<GridPoint, std::size_t> grid_of(ElementKind kind, int order) {
    std::map<GridPoint, std::size_t> grid;
    const std::vector<GridPoint> points = elements::gmsh_nodes(kind, order);
    for (std::size_t i = 0; i < points.size(); ++i) {
        grid.emplace(points[i], i);
    }
    return grid;
}

void blend_quadrilateral(int order, std::vector<Vec3>& nodes) {
    Square square(order);
    const auto grid = grid_of(ElementKind::Quadrilateral, order);
    for (const auto& [p, i] : grid) {
        square(p[0], p[1]) = nodes[i];
    }
    square.blend();
    for (const auto& [p, i] : grid) {
        nodes[i] = square(p[0], p[1]);
    }
}

/// Sets the nodes inside of prisms and hexahedra.
void blend_levels(ElementKind kind, int order, std::vector<Vec3>& nodes) {
    const auto grid = grid_of(kind, order);
    const ElementKind flat = kind == ElementKind::Prism ? ElementKind::Triangle : ElementKind::Quadrilateral;
    const std::vector<GridPoint> level = elements::gmsh_nodes(flat, order);
    for (int k = 1; k < order; ++k) {
        const double z = static_cast<double>(k) / order;
        std::vector<Vec3> linear;
        std::vector<Vec3> other;
        for (const GridPoint& p : level) {
            linear.push_back((1.0 - z) * nodes[grid.at({p[0], p[1], 0})] + z * nodes[grid.at({p[0], p[1], order})]);
            other.push_back(nodes[grid.at({p[0], p[1], k})] - linear.back());
        }
        if (flat == ElementKind::Triangle) {
            blend_simplex(2, order, other);
        } else {
            blend_quadrilateral(order, other);
        }
        for (std::size_t i = 0; i < level.size(); ++i) {
            nodes[grid.at({level[i][0], level[i][1], k})] = linear[i] + other[i];
        }
    }
}

void blend_pyramid(int order, std::vector<Vec3>& nodes) {
    const auto grid = grid_of(ElementKind::Pyramid, order);
    for (int k = 1; k + 1 < order; ++k) {
        const int n = order - k;
        Square square(n);
        const auto node = [&](int i, int j) { return grid.at({2 * i - n, 2 * j - n, k}); };
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= n; ++j) {
                square(i, j) = nodes[node(i, j)];
            }
        }
        square.blend();
        for (int i = 1; i < n; ++i) {
            for (int j = 1; j < n; ++j) {
                nodes[node(i, j)] = square(i, j);
            }
        }
    }
}

void blend(ElementKind kind, int order, std::vector<Vec3>& nodes) {
    switch (kind) {
        case ElementKind::Triangle:
            blend_simplex(2, order, nodes);
            break;
        case ElementKind::Tetrahedron:
            if (order > 3) {
                blend_simplex(3, order, nodes);
            }
            break;
        case ElementKind::Quadrilateral:
            blend_quadrilateral(order, nodes);
            break;
        case ElementKind::Prism:
        case ElementKind::Hexahedron:
            blend_levels(kind, order, nodes);
            break;
        case ElementKind::Pyramid:
            blend_pyramid(order, nodes);
            break;
    }
}

/// The nodes that lie on no edge or face of the element.
std::vector<int> inner_of(ElementKind kind, int order) {
    const Eigen::MatrixXd& weights = corner_weights(kind, order);
    std::vector<int> inner;
    for (Eigen::Index i = 0; i < weights.rows(); ++i) {
        if ((weights.row(i).array() > 1e-9).all()) {
            inner.push_back(static_cast<int>(i));
        }
    }
    return inner;
}

}  // namespace

const Blending& Blending::of(ElementKind kind, int order) {
    static std::mutex mutex;
    static auto& known = never_destroyed<std::map<std::pair<ElementKind, int>, Blending>>({});
    const std::lock_guard<std::mutex> lock(mutex);
    const auto [found, fresh] = known.try_emplace({kind, order});
    if (fresh) {
        Blending& made = found->second;
        made.inner = inner_of(kind, order);
        const int count = elements::full_node_count(kind, order);
        made.from = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(made.inner.size()), count);
        for (int j = 0; j < count && !made.inner.empty(); ++j) {
            std::vector<Vec3> unit(at(count), Vec3::Zero());
            unit[at(j)] = Vec3::UnitX();
            if (std::find(made.inner.begin(), made.inner.end(), j) != made.inner.end()) {
                continue;
            }
            blend(kind, order, unit);
            for (std::size_t i = 0; i < made.inner.size(); ++i) {
                made.from(static_cast<Eigen::Index>(i), j) = unit[at(made.inner[i])].x();
            }
        }
    }
    return found->second;
}

void Blending::apply(std::vector<Vec3>& nodes) const {
    for (std::size_t i = 0; i < inner.size(); ++i) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            const double weight = from(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            if (weight != 0.0) {
                sum += weight * nodes[j];
            }
        }
        nodes[at(inner[i])] = sum;
    }
}

}  // namespace mq::given

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/blending.h"

#include <Eigen/QR>

#include "base/memory/never_destroyed.h"

namespace mq::elements {

namespace {

/// Rows: inner points; columns: all points of the lattice, zero at inner ones.
struct Blend {
    std::vector<int> inner;
    Eigen::MatrixXd weights;
};

/// Value at node `at` of the blended map in which only edge (a, b) deviates, by Bernstein polynomial `point`.
double carried(const Lattice& lattice, int point, std::size_t a, std::size_t b, const Barycentric& at) {
    const double product = at[a] * at[b];
    const double s = at[b] + 0.5 * (1.0 - at[a] - at[b]);
    const Exponents& e = lattice.exponents(point);
    const double bernstein = lattice.multinomial(point) * std::pow(1.0 - s, e[a]) * std::pow(s, e[b]);
    return product / (s * (1.0 - s)) * bernstein;
}

/// Blended value at every inner node from control points of the boundary.
Eigen::MatrixXd nodes_from_control(const Lattice& lattice, const std::vector<int>& inner) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(inner.size()), lattice.size());
    for (std::size_t row = 0; row < inner.size(); ++row) {
        const Barycentric at = lattice.node(inner[row]);
        const auto i = static_cast<Eigen::Index>(row);
        for (std::size_t k = 0; k < 3; ++k) {
            matrix(i, lattice.corner(static_cast<int>(k))) += at[k];
        }
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3;
            for (int point = 0; point < lattice.size(); ++point) {
                const Exponents& e = lattice.exponents(point);
                if (lattice.carriers(point) != 2 || e[a] == 0 || e[b] == 0) {
                    continue;
                }
                // The offset from straight is the control point less its linear place.
                const double weight = carried(lattice, point, a, b, at);
                matrix(i, point) += weight;
                matrix(i, lattice.corner(static_cast<int>(a))) -= weight * e[a] / lattice.degree();
                matrix(i, lattice.corner(static_cast<int>(b))) -= weight * e[b] / lattice.degree();
            }
        }
    }
    return matrix;
}

Blend triangle_blend(const Lattice& lattice) {
    Blend blend;
    for (int i = 0; i < lattice.size(); ++i) {
        if (lattice.carriers(i) == 3) {
            blend.inner.push_back(i);
        }
    }
    if (blend.inner.empty()) {
        return blend;
    }
    // All nodes from boundary control points, then back to control points.
    Eigen::MatrixXd nodes = Eigen::MatrixXd::Zero(lattice.size(), lattice.size());
    for (int i = 0; i < lattice.size(); ++i) {
        const std::vector<double> b = bernstein_values(lattice, lattice.node(i));
        for (int j = 0; j < lattice.size() && lattice.carriers(i) < 3; ++j) {
            nodes(i, j) = lattice.carriers(j) < 3 ? b[static_cast<std::size_t>(j)] : 0.0;
        }
    }
    const Eigen::MatrixXd inner = nodes_from_control(lattice, blend.inner);
    for (std::size_t row = 0; row < blend.inner.size(); ++row) {
        nodes.row(blend.inner[row]) = inner.row(static_cast<Eigen::Index>(row));
    }
    const Eigen::MatrixXd all = nodes_to_bezier_matrix(lattice) * nodes;
    blend.weights.resize(static_cast<Eigen::Index>(blend.inner.size()), lattice.size());
    for (std::size_t row = 0; row < blend.inner.size(); ++row) {
        blend.weights.row(static_cast<Eigen::Index>(row)) = all.row(blend.inner[row]);
    }
    return blend;
}

Blend tetrahedron_blend(const Lattice& lattice) {
    Blend blend;
    std::vector<int> outer;
    for (int i = 0; i < lattice.size(); ++i) {
        (lattice.carriers(i) == 4 ? blend.inner : outer).push_back(i);
    }
    if (blend.inner.empty()) {
        return blend;
    }
    // Degree elevation writes each Bernstein polynomial of the lower degree in those of this one.
    const Lattice& lower = Lattice::of(3, lattice.degree() - 1);
    Eigen::MatrixXd elevation = Eigen::MatrixXd::Zero(lattice.size(), lower.size());
    for (int j = 0; j < lower.size(); ++j) {
        for (std::size_t k = 0; k < 4; ++k) {
            Exponents e = lower.exponents(j);
            ++e[k];
            elevation(lattice.index(e), j) += static_cast<double>(e[k]) / lattice.degree();
        }
    }
    Eigen::MatrixXd known(static_cast<Eigen::Index>(outer.size()), lower.size());
    for (std::size_t i = 0; i < outer.size(); ++i) {
        known.row(static_cast<Eigen::Index>(i)) = elevation.row(outer[i]);
    }
    blend.weights = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(blend.inner.size()), lattice.size());
    const auto solver = known.transpose().completeOrthogonalDecomposition();
    for (std::size_t row = 0; row < blend.inner.size(); ++row) {
        const Eigen::VectorXd wanted = elevation.row(blend.inner[row]).transpose();
        const Eigen::VectorXd weights = solver.solve(wanted);
        for (std::size_t i = 0; i < outer.size(); ++i) {
            blend.weights(static_cast<Eigen::Index>(row), outer[i]) = weights[static_cast<Eigen::Index>(i)];
        }
    }
    return blend;
}

void apply(const Blend& blend, std::vector<Vec3>& points) {
    for (std::size_t row = 0; row < blend.inner.size(); ++row) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t j = 0; j < points.size(); ++j) {
            const double weight = blend.weights(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(j));
            if (weight != 0.0) {
                sum += weight * points[j];
            }
        }
        points[static_cast<std::size_t>(blend.inner[row])] = sum;
    }
}

template <typename Make>
std::vector<Blend> for_orders(int dimension, Make&& make) {
    std::vector<Blend> all(1);
    for (int order = 1; order <= kMaxOrder; ++order) {
        all.push_back(make(Lattice::of(dimension, order)));
    }
    return all;
}

const Blend& triangle_blend_of(int order) {
    static const auto& all = never_destroyed(for_orders(2, triangle_blend));
    return all[static_cast<std::size_t>(order)];
}

const Blend& tetrahedron_blend_of(int order) {
    static const auto& all = never_destroyed(for_orders(3, tetrahedron_blend));
    return all[static_cast<std::size_t>(order)];
}

}  // namespace

void blend_triangle(const Lattice& lattice, std::vector<Vec3>& control) {
    apply(triangle_blend_of(lattice.degree()), control);
}

void blend_tetrahedron(const Lattice& lattice, std::vector<Vec3>& control) {
    apply(tetrahedron_blend_of(lattice.degree()), control);
}

void spread_inner_gradient(const Lattice& lattice, std::vector<Vec3>& by_control) {
    const Blend& blend = tetrahedron_blend_of(lattice.degree());
    for (std::size_t row = 0; row < blend.inner.size(); ++row) {
        const Vec3 inner = by_control[static_cast<std::size_t>(blend.inner[row])];
        for (std::size_t j = 0; j < by_control.size(); ++j) {
            by_control[j] += blend.weights(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(j)) * inner;
        }
        by_control[static_cast<std::size_t>(blend.inner[row])] = Vec3::Zero();
    }
}

}  // namespace mq::elements

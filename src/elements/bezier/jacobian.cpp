// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/jacobian.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mq::elements {

namespace {

// Bound of the rounding error, relative to the product of the lengths. Each coefficient is a sum, with positive weights
// that add up to one, of box products; each of those has an error of less than 12 units in the last place of the
// product of the lengths, and the sums add fewer than 50.
constexpr double kCoefficientRounding = 64.0 * std::numeric_limits<double>::epsilon();

double longest(const std::vector<Vec3>& vectors) {
    double square = 0.0;
    for (const Vec3& v : vectors) {
        square = std::max(square, v.squaredNorm());
    }
    return std::sqrt(square);
}

/// The product of two polynomials of degrees m and n, where `times` multiplies their coefficients.
template <typename Times>
auto product(int dimension, const std::vector<Vec3>& a, int m, const std::vector<Vec3>& b, int n, const Times& times) {
    using Value = decltype(times(a[0], b[0]));
    const ProductTable& table = ProductTable::of(dimension, m, n);
    std::vector<Value> result(static_cast<std::size_t>(Lattice::of(dimension, m + n).size()),
                              times(Vec3::Zero(), Vec3::Zero()));
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            const ProductTable::Entry& e = table.at(static_cast<int>(i), static_cast<int>(j));
            result[static_cast<std::size_t>(e.target)] += e.weight * times(a[i], b[j]);
        }
    }
    return result;
}

std::vector<Vec3> cross(int dimension, const std::vector<Vec3>& a, int m, const std::vector<Vec3>& b, int n) {
    return product(dimension, a, m, b, n, [](const Vec3& x, const Vec3& y) -> Vec3 { return x.cross(y); });
}

std::vector<double> dot(int dimension, const std::vector<Vec3>& a, int m, const std::vector<Vec3>& b, int n) {
    return product(dimension, a, m, b, n, [](const Vec3& x, const Vec3& y) { return x.dot(y); });
}

}  // namespace

JacobianForm jacobian_of(const Lattice& lattice, const std::vector<Vec3>& control) {
    const int m = lattice.degree() - 1;
    const std::vector<Vec3> r = derivative(lattice, control, 1);
    const std::vector<Vec3> s = derivative(lattice, control, 2);
    const std::vector<Vec3> t = derivative(lattice, control, 3);
    JacobianForm form;
    form.lattice = &ProductLattice::simplex(3, 3 * m);
    form.coefficients = dot(3, r, m, cross(3, s, m, t, m), 2 * m);
    form.rounding = kCoefficientRounding * longest(r) * longest(s) * longest(t);
    return form;
}

JacobianForm jacobian_by_nodes(const Lattice& lattice, const std::vector<Vec3>& control) {
    JacobianForm form = jacobian_of(lattice, control);
    double far = 0.0;
    for (const Vec3& p : control) {
        far = std::max(far, p.cwiseAbs().maxCoeff());
    }
    double side = 0.0;
    for (int k = 1; k <= 3; ++k) {
        side = std::max(side, longest(derivative(lattice, control, k)));
    }
    // Nodes are off by less than four units in the last place, and control points by at most 3^q times as much: the
    // norm of interpolation at even nodes is less than that at orders 2 to 5. A derivative has q times the errors of
    // two control points.
    const int q = lattice.degree();
    const double point = std::pow(3.0, q) * 4.0 * std::numeric_limits<double>::epsilon() * far;
    form.rounding += 3.0 * (2.0 * q * point) * side * side;
    return form;
}

double jacobian_at(const Lattice& lattice, const std::vector<Vec3>& control, const Barycentric& at) {
    const Lattice& lower = Lattice::of(3, lattice.degree() - 1);
    const Vec3 r = value(lower, derivative(lattice, control, 1), at);
    const Vec3 s = value(lower, derivative(lattice, control, 2), at);
    const Vec3 t = value(lower, derivative(lattice, control, 3), at);
    return r.dot(s.cross(t));
}

JacobianForm normal_component(const Lattice& lattice, const std::vector<Vec3>& control,
                              const std::vector<Vec3>& cad_normals) {
    const int m = lattice.degree() - 1;
    const std::vector<Vec3> r = derivative(lattice, control, 1);
    const std::vector<Vec3> s = derivative(lattice, control, 2);
    const std::vector<Vec3> normals = nodes_to_bezier(lattice, cad_normals);
    JacobianForm form;
    form.lattice = &ProductLattice::simplex(2, 3 * lattice.degree() - 2);
    form.coefficients = dot(2, normals, lattice.degree(), cross(2, r, m, s, m), 2 * m);
    form.rounding = kCoefficientRounding * longest(r) * longest(s) * longest(normals);
    return form;
}

NormalForm normal_of(const Lattice& lattice, const std::vector<Vec3>& control) {
    const int m = lattice.degree() - 1;
    const std::vector<Vec3> r = derivative(lattice, control, 1);
    const std::vector<Vec3> s = derivative(lattice, control, 2);
    return {&ProductLattice::simplex(2, 2 * m), cross(2, r, m, s, m), kCoefficientRounding * longest(r) * longest(s),
            0};
}

JacobianForm stretch_of(const Lattice& lattice, const std::vector<Vec3>& control) {
    const int dimension = lattice.dimension();
    const int m = lattice.degree() - 1;
    JacobianForm form;
    form.lattice = &ProductLattice::simplex(dimension, 2 * m);
    form.coefficients.assign(static_cast<std::size_t>(form.lattice->size()), 0.0);
    const auto add = [&](const std::vector<Vec3>& along) {
        const std::vector<double> square = dot(dimension, along, m, along, m);
        for (std::size_t i = 0; i < square.size(); ++i) {
            form.coefficients[i] += square[i];
        }
        form.rounding += kCoefficientRounding * longest(along) * longest(along);
    };
    for (int k = 1; k <= dimension; ++k) {
        const std::vector<Vec3> from_first = derivative(lattice, control, k);
        add(from_first);
        for (int j = 1; j < k; ++j) {
            std::vector<Vec3> between = derivative(lattice, control, j);
            for (std::size_t i = 0; i < between.size(); ++i) {
                between[i] -= from_first[i];
            }
            add(between);
        }
    }
    return form;
}

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/element_jacobian.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elements/product/element_derivatives.h"

namespace mq::elements {

namespace {

/// Largest relative error of one rounded operation.
constexpr double kUnit = 0.5 * std::numeric_limits<double>::epsilon();

std::vector<double> multinomials_of(const ProductLattice& lattice) {
    std::vector<double> all;
    for (int i = 0; i < lattice.size(); ++i) {
        all.push_back(lattice.multinomial(i));
    }
    return all;
}

/// The nodes relative to their mean, in units of a power of two near their largest distance from it, so that scaling is
/// exact. Returns the largest distance in these units.
/// @param exponent  of the power of two
double to_local(const std::vector<Vec3>& nodes, std::vector<Vec3>& local, int& exponent) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& node : nodes) {
        mean += node / static_cast<double>(nodes.size());
    }
    local.clear();
    double farthest = 0.0;
    for (const Vec3& node : nodes) {
        local.push_back(node - mean);
        farthest = std::max(farthest, local.back().lpNorm<Eigen::Infinity>());
    }
    exponent = 0;
    if (!(farthest > 0.0) || !std::isfinite(farthest)) {
        return farthest;
    }
    exponent = std::ilogb(farthest);
    double size = 0.0;
    for (Vec3& p : local) {
        p = Vec3(std::ldexp(p.x(), -exponent), std::ldexp(p.y(), -exponent), std::ldexp(p.z(), -exponent));
        size = std::max(size, p.norm());
    }
    return size;
}

}  // namespace

ElementJacobian::ElementJacobian(ElementKind kind, int order, int nodes) : kind_(kind) {
    for (const NodalPolynomial& given : derivatives_of(kind, order, nodes)) {
        Derivative d{given.lattice, given.from_nodes.cast<double>(), multinomials_of(given.lattice), 0.0};
        d.gain = d.from_nodes.cwiseAbs().rowwise().sum().maxCoeff();
        for (int i = 0; i < given.lattice.size(); ++i) {
            d.from_nodes.row(i) *= d.multinomials[static_cast<std::size_t>(i)];
        }
        derivatives_.push_back(std::move(d));
    }
    const std::size_t n = derivatives_.size();
    products_.push_back(product_of(derivatives_[n - 2].lattice, derivatives_[n - 1].lattice));
    if (n == 3) {
        products_.push_back(product_of(derivatives_[0].lattice, products_[0].lattice));
    }
    multinomials_ = multinomials_of(products_.back().lattice);
}

ElementJacobian::Product ElementJacobian::product_of(const ProductLattice& a, const ProductLattice& b) {
    Product product{a.times(b), {}, std::min(a.size(), b.size())};
    product.targets.reserve(static_cast<std::size_t>(a.size()) * static_cast<std::size_t>(b.size()));
    for (int i = 0; i < a.size(); ++i) {
        for (int j = 0; j < b.size(); ++j) {
            product.targets.push_back(a.index_of_sum(i, b, j, product.lattice));
        }
    }
    return product;
}

ElementJacobian::Field ElementJacobian::derivative(const Derivative& derivative, const std::vector<Vec3>& local,
                                                   double size) {
    // Sums are made of sums of this number of products, as errors grow with the number of terms.
    constexpr std::size_t kTerms = 16;
    const auto count = static_cast<std::size_t>(derivative.lattice.size());
    Field field;
    std::vector<double> partial(count);
    for (std::size_t k = 0; k < 3; ++k) {
        field.c[k].assign(count, 0.0);
        for (std::size_t begin = 0; begin < local.size(); begin += kTerms) {
            std::fill(partial.begin(), partial.end(), 0.0);
            for (std::size_t j = begin; j < std::min(begin + kTerms, local.size()); ++j) {
                const double* column = derivative.from_nodes.col(static_cast<Eigen::Index>(j)).data();
                const double x = local[j][static_cast<Eigen::Index>(k)];
                for (std::size_t i = 0; i < count; ++i) {
                    partial[i] += column[i] * x;
                }
            }
            for (std::size_t i = 0; i < count; ++i) {
                field.c[k][i] += partial[i];
            }
        }
    }
    // kOther counts the roundings besides those of the sums: 1 for node differences, up to 3 for each weight, the rest
    // for multinomials.
    constexpr double kOther = 10.0;
    const auto sums = static_cast<double>(kTerms + local.size() / kTerms + 1);
    field.error = derivative.gain * size * kUnit * (sums + kOther);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 v(field.c[0][i], field.c[1][i], field.c[2][i]);
        field.longest = std::max(field.longest, v.norm() / derivative.multinomials[i]);
    }
    field.longest += field.error;
    return field;
}

ElementJacobian::Field ElementJacobian::cross(const Product& product, const Field& a, const Field& b) {
    Field result;
    for (std::vector<double>& list : result.c) {
        list.assign(static_cast<std::size_t>(product.lattice.size()), 0.0);
    }
    const int* target = product.targets.data();
    for (std::size_t i = 0; i < a.c[0].size(); ++i) {
        const double ax = a.c[0][i];
        const double ay = a.c[1][i];
        const double az = a.c[2][i];
        for (std::size_t j = 0; j < b.c[0].size(); ++j) {
            const auto t = static_cast<std::size_t>(*target++);
            result.c[0][t] += ay * b.c[2][j] - az * b.c[1][j];
            result.c[1][t] += az * b.c[0][j] - ax * b.c[2][j];
            result.c[2][t] += ax * b.c[1][j] - ay * b.c[0][j];
        }
    }
    // Four roundings of a cross product and one of each sum; a coefficient is a mean of such products.
    constexpr double kOther = 6.0;
    result.longest = a.longest * b.longest;
    result.error = a.error * b.longest + a.longest * b.error + result.longest * kUnit * (product.terms + kOther);
    return result;
}

void ElementJacobian::divide_by_multinomials(std::vector<double>& coefficients) const {
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        coefficients[i] /= multinomials_[i];
    }
}

JacobianForm ElementJacobian::along_mean(const Field& r, const Field& s) const {
    const Field normal = cross(products_[0], r, s);
    // The mean of a polynomial is that of its Bernstein coefficients.
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < multinomials_.size(); ++i) {
        mean += Vec3(normal.c[0][i], normal.c[1][i], normal.c[2][i]) / multinomials_[i];
    }
    const double length = mean.norm();
    if (length > 0.0) {
        mean /= length;
    }
    JacobianForm form{&products_[0].lattice, normal.c[0], 0.0};
    for (std::size_t i = 0; i < form.coefficients.size(); ++i) {
        form.coefficients[i] = mean.x() * normal.c[0][i] + mean.y() * normal.c[1][i] + mean.z() * normal.c[2][i];
    }
    divide_by_multinomials(form.coefficients);
    constexpr double kOther = 16.0;
    form.rounding = normal.error + normal.longest * kUnit * kOther;
    return form;
}

JacobianForm ElementJacobian::box_product(const Field& r, const Field& s, const Field& t) const {
    const Field normal = cross(products_[0], s, t);
    JacobianForm form{&products_[1].lattice, std::vector<double>(multinomials_.size(), 0.0), 0.0};
    const int* target = products_[1].targets.data();
    for (std::size_t i = 0; i < r.c[0].size(); ++i) {
        const double x = r.c[0][i];
        const double y = r.c[1][i];
        const double z = r.c[2][i];
        for (std::size_t j = 0; j < normal.c[0].size(); ++j) {
            form.coefficients[static_cast<std::size_t>(*target++)] +=
                x * normal.c[0][j] + y * normal.c[1][j] + z * normal.c[2][j];
        }
    }
    divide_by_multinomials(form.coefficients);
    constexpr double kOther = 10.0;
    const double product = r.longest * normal.longest;
    form.rounding =
        r.error * normal.longest + r.longest * normal.error + product * kUnit * (products_[1].terms + kOther);
    return form;
}

JacobianForm ElementJacobian::of(const std::vector<Vec3>& nodes) const {
    std::vector<Vec3> local;
    int exponent = 0;
    const double size = to_local(nodes, local, exponent);
    std::vector<Field> fields;
    for (const Derivative& d : derivatives_) {
        fields.push_back(derivative(d, local, size));
    }
    JacobianForm form =
        fields.size() == 2 ? along_mean(fields[0], fields[1]) : box_product(fields[0], fields[1], fields[2]);
    form.exponent = static_cast<int>(fields.size()) * exponent;
    return form;
}

double ElementJacobian::volume(const std::vector<Vec3>& nodes) const {
    const JacobianForm form = of(nodes);
    const ProductLattice& lattice = *form.lattice;
    double sum = 0.0;
    for (int i = 0; i < lattice.size(); ++i) {
        // All Bernstein polynomials of a degree have the same integral.
        double weight = 1.0 / lattice.size();
        if (kind_ == ElementKind::Pyramid) {
            // The element of volume is (1 - z)^2 du dv dz.
            const double n = lattice.factor(2).degree();
            const double k = lattice.factor(2).exponents(lattice.indices(i)[2])[1];
            weight *= (n + 1.0) * (n - k + 1.0) * (n - k + 2.0) / ((n + 1.0) * (n + 2.0) * (n + 3.0));
        }
        sum += weight * form.coefficients[static_cast<std::size_t>(i)];
    }
    const double domain = kind_ == ElementKind::Tetrahedron ? 1.0 / 6.0 : kind_ == ElementKind::Prism ? 0.5 : 1.0;
    return std::ldexp(domain * sum, form.exponent);
}

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "elements/product/check_elements.h"
#include "elements/product/reference_nodes.h"

/// Elements that are images of the reference element under a known map, and their Jacobians by formula.
namespace mq::elements {

constexpr std::array<ElementKind, 6> kAllKinds{ElementKind::Triangle,    ElementKind::Quadrilateral,
                                               ElementKind::Tetrahedron, ElementKind::Pyramid,
                                               ElementKind::Prism,       ElementKind::Hexahedron};

/// A polynomial map of the reference element; for pyramids with the rational term x y / (1 - z).
class PolynomialMap {
  public:
    /// The identity, and random multiples of all monomials in the space of the kind, up to `size` together.
    PolynomialMap(ElementKind kind, int order, bool serendipity, double size, std::mt19937& random)
        : rational_(kind == ElementKind::Pyramid), flat_(dimension_of(kind) == 2) {
        for (int a = 0; a <= order; ++a) {
            for (int b = 0; b <= order; ++b) {
                for (int c = 0; c <= (flat_ ? 0 : order); ++c) {
                    if (holds(kind, order, serendipity, {a, b, c})) {
                        monomials_.push_back({a, b, c});
                    }
                }
            }
        }
        std::uniform_real_distribution<double> uniform(-size, size);
        const double each = 1.0 / static_cast<double>(monomials_.size() + 1);
        for (std::size_t i = 0; i <= monomials_.size(); ++i) {
            weights_.push_back(each * Vec3(uniform(random), uniform(random), flat_ ? 0.0 : uniform(random)));
        }
    }

    Vec3 at(const Vec3& x) const {
        Vec3 sum = x;
        for (std::size_t i = 0; i < monomials_.size(); ++i) {
            const auto& [a, b, c] = monomials_[i];
            sum += weights_[i] * std::pow(x.x(), a) * std::pow(x.y(), b) * std::pow(x.z(), c);
        }
        // At the apex the rational term is zero.
        return rational_ && x.z() != 1.0 ? Vec3(sum + weights_.back() * x.x() * x.y() / (1.0 - x.z())) : sum;
    }

    double jacobian(const Vec3& x) const {
        Eigen::Matrix3d d = Eigen::Matrix3d::Identity();
        for (std::size_t i = 0; i < monomials_.size(); ++i) {
            const auto& [a, b, c] = monomials_[i];
            const Vec3 gradient(slope(x.x(), a) * std::pow(x.y(), b) * std::pow(x.z(), c),
                                std::pow(x.x(), a) * slope(x.y(), b) * std::pow(x.z(), c),
                                std::pow(x.x(), a) * std::pow(x.y(), b) * slope(x.z(), c));
            d += weights_[i] * gradient.transpose();
        }
        if (rational_) {
            const double rest = 1.0 - x.z();
            const Vec3 gradient(x.y() / rest, x.x() / rest, x.x() * x.y() / (rest * rest));
            d += weights_.back() * gradient.transpose();
        }
        return d.determinant();
    }

    std::vector<Vec3> nodes(ElementKind kind, int order, int count) const {
        std::vector<Vec3> result;
        for (const Vec3& x : reference_nodes(kind, order)) {
            result.push_back(at(x));
        }
        result.resize(static_cast<std::size_t>(count));
        return result;
    }

  private:
    static bool holds(ElementKind kind, int order, bool serendipity, const std::array<int, 3>& e) {
        const int plane = e[0] + e[1];
        const bool square_by_square = (e[0] == 2) + (e[1] == 2) + (e[2] == 2) > 1;
        switch (kind) {
            case ElementKind::Triangle:
                return plane <= order;
            case ElementKind::Tetrahedron:
            case ElementKind::Pyramid:
                return plane + e[2] <= order;
            case ElementKind::Prism:
                return plane <= order && !(serendipity && plane == 2 && e[2] == 2);
            case ElementKind::Quadrilateral:
            case ElementKind::Hexahedron:
                break;
        }
        return !(serendipity && square_by_square);
    }
    static double slope(double x, int exponent) { return exponent == 0 ? 0.0 : exponent * std::pow(x, exponent - 1); }

    bool rational_;
    bool flat_;
    std::vector<std::array<int, 3>> monomials_;
    std::vector<Vec3> weights_;
};

/// The place on Gmsh's reference element of a point of the domain on which J is a polynomial.
inline Vec3 on_reference(ElementKind kind, const ProductPoint& p) {
    switch (kind) {
        case ElementKind::Triangle:
        case ElementKind::Tetrahedron:
            return {p[0][1], p[0][2], p[0][3]};
        case ElementKind::Quadrilateral:
            return {2.0 * p[0][1] - 1.0, 2.0 * p[1][1] - 1.0, 0.0};
        case ElementKind::Prism:
            return {p[0][1], p[0][2], 2.0 * p[1][1] - 1.0};
        case ElementKind::Pyramid:
            return {(2.0 * p[0][1] - 1.0) * (1.0 - p[2][1]), (2.0 * p[1][1] - 1.0) * (1.0 - p[2][1]), p[2][1]};
        case ElementKind::Hexahedron:
            break;
    }
    return {2.0 * p[0][1] - 1.0, 2.0 * p[1][1] - 1.0, 2.0 * p[2][1] - 1.0};
}

/// The value of a polynomial on a product of simplices, from its Bernstein coefficients.
inline double value_at(const ProductLattice& lattice, const std::vector<double>& coefficients, const ProductPoint& at) {
    double sum = 0.0;
    for (int i = 0; i < lattice.size(); ++i) {
        double product = coefficients[static_cast<std::size_t>(i)] * lattice.multinomial(i);
        for (std::size_t f = 0; f < static_cast<std::size_t>(lattice.factors()); ++f) {
            const Exponents& e = lattice.factor(static_cast<int>(f)).exponents(lattice.indices(i)[f]);
            for (std::size_t k = 0; k < 4; ++k) {
                product *= std::pow(at[f][k], e[k]);
            }
        }
        sum += product;
    }
    return sum;
}

}  // namespace mq::elements

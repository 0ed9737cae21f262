// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/vec.h"
#include "elements/bezier/jacobian.h"
#include "elements/product/element_kind.h"

namespace mq::elements {

/// Computes Jacobians from the nodes of elements of one kind and order.
class ElementJacobian {
  public:
    /// @param nodes  as in `derivatives_of`, which defines the domain on which J is a polynomial
    /// @throws InvalidInput if elements of this kind and order have another number of nodes
    ElementJacobian(ElementKind kind, int order, int nodes);

    /// J of a solid element; of a surface element the component of the normal x_r x x_s along its mean in the element.
    /// Both are multiplied by a positive constant. Nodes are taken as exact: the bound of rounding covers all that is
    /// computed from them. Where that overflows, coefficients are not finite.
    JacobianForm of(const std::vector<Vec3>& nodes) const;

    /// The volume of a solid element: the integral of J over the reference element, negative where it is inverted.
    double volume(const std::vector<Vec3>& nodes) const;

  private:
    /// A derivative of the map: `from_nodes` gives its Bernstein coefficients times their multinomials, since products
    /// of polynomials in that form are plain sums of products.
    struct Derivative {
        ProductLattice lattice;
        Eigen::MatrixXd from_nodes;
        std::vector<double> multinomials;
        double gain = 0.0;  // largest sum of the absolute weights of a coefficient
    };
    /// Which coefficient of the product each pair of coefficients of two polynomials contributes to.
    struct Product {
        ProductLattice lattice;
        std::vector<int> targets;
        int terms = 0;  // number of terms in the longest sum
    };
    /// Vectors times multinomials, as one list for each coordinate.
    struct Field {
        std::array<std::vector<double>, 3> c;
        double longest = 0.0;  // largest length of a vector without its multinomial, plus its error
        double error = 0.0;
    };

    static Product product_of(const ProductLattice& a, const ProductLattice& b);
    static Field derivative(const Derivative& derivative, const std::vector<Vec3>& local, double size);
    static Field cross(const Product& product, const Field& a, const Field& b);
    void divide_by_multinomials(std::vector<double>& coefficients) const;
    JacobianForm along_mean(const Field& r, const Field& s) const;
    JacobianForm box_product(const Field& r, const Field& s, const Field& t) const;

    ElementKind kind_;
    std::vector<Derivative> derivatives_;
    std::vector<Product> products_;  // for the last two derivatives, then for the first one and that product
    std::vector<double> multinomials_;
};

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/tensor_patch.h"

#include <cstddef>
#include <utility>

#include "elements/product/element_derivatives.h"
#include "elements/product/reference_nodes.h"

namespace mq::elements {

namespace {

double binomial(int n, int k) {
    return Lattice::of(1, n).multinomial(k);
}

std::size_t at(int order, int i, int j) {
    return static_cast<std::size_t>(i * (order + 1) + j);
}

/// The half between the corners (0, 0), (1, 0) and (1, 1): there u = b1 + b2, 1 - u = b0, v = b2 and 1 - v = b0 + b1.
/// @param turned  whether to return the other half, which has u and v, and so corners 1 and 2, exchanged
std::vector<Vec3> half(int order, const std::vector<Vec3>& control, bool turned) {
    const Lattice& lattice = Lattice::of(2, 2 * order);
    std::vector<Vec3> found(static_cast<std::size_t>(lattice.size()), Vec3::Zero());
    for (int i = 0; i <= order; ++i) {
        for (int j = 0; j <= order; ++j) {
            const Vec3& p = control[turned ? at(order, j, i) : at(order, i, j)];
            const double of_point = binomial(order, i) * binomial(order, j);
            for (int a = 0; a <= i; ++a) {  // the powers of b1 in (b1 + b2)^i and, b, in (b0 + b1)^(order - j)
                for (int b = 0; b <= order - j; ++b) {
                    Exponents e{2 * order - i - j - b, a + b, i - a + j, 0};
                    if (turned) {
                        std::swap(e[1], e[2]);
                    }
                    const int k = lattice.index(e);
                    const double weight = of_point * binomial(i, a) * binomial(order - j, b) / lattice.multinomial(k);
                    found[static_cast<std::size_t>(k)] += weight * p;
                }
            }
        }
    }
    return found;
}

}  // namespace

std::vector<Vec3> tensor_control(int order, const std::vector<Vec3>& given) {
    const std::vector<Vec3> nodes = all_nodes(ElementKind::Quadrilateral, order, given);
    const std::vector<GridPoint> places = gmsh_nodes(ElementKind::Quadrilateral, order);
    const Eigen::MatrixXd& along = nodes_to_bezier_matrix(Lattice::of(1, order));
    std::vector<Vec3> found(nodes.size(), Vec3::Zero());
    for (int i = 0; i <= order; ++i) {
        for (int j = 0; j <= order; ++j) {
            for (std::size_t g = 0; g < places.size(); ++g) {
                found[at(order, i, j)] += along(i, places[g][0]) * along(j, places[g][1]) * nodes[g];
            }
        }
    }
    return found;
}

std::array<std::vector<Vec3>, 2> halves_of_quadrilateral(int order, const std::vector<Vec3>& control) {
    return {half(order, control, false), half(order, control, true)};
}

}  // namespace mq::elements

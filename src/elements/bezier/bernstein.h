// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "elements/bezier/simplex_lattice.h"

/// Polynomials on simplices in Bernstein form (Farin 1993): products, values, halving, and conversion from and to
/// nodes.
namespace mq::elements {

/// Coefficients of the product of two Bernstein polynomials of degrees m and n: pair (i, j) adds weight * a_i * b_j to
/// coefficient `target`.
class ProductTable {
  public:
    struct Entry {
        int target;
        double weight;
    };
    static const ProductTable& of(int dimension, int m, int n);
    const Entry& at(int i, int j) const { return entries_[static_cast<std::size_t>(i * columns_ + j)]; }

    ProductTable(int dimension, int m, int n);

  private:
    int columns_;
    std::vector<Entry> entries_;
};

/// Values of all Bernstein polynomials of the lattice at a point.
std::vector<double> bernstein_values(const Lattice& lattice, const Barycentric& at);

double value(const Lattice& lattice, const std::vector<double>& coefficients, const Barycentric& at);
Vec3 value(const Lattice& lattice, const std::vector<Vec3>& control, const Barycentric& at);

/// Derivative along the edge from corner 0 to corner `k`: coefficients on the lattice of one degree less.
std::vector<Vec3> derivative(const Lattice& lattice, const std::vector<Vec3>& control, int k);

/// Control points from nodes and back. The two forms are the same polynomial; the conversion matrices have rational
/// entries, found in extended precision and rounded once.
std::vector<Vec3> nodes_to_bezier(const Lattice& lattice, const std::vector<Vec3>& nodes);
std::vector<Vec3> bezier_to_nodes(const Lattice& lattice, const std::vector<Vec3>& control);
/// @param lattice of order 1 to kMaxOrder.
const Eigen::MatrixXd& nodes_to_bezier_matrix(const Lattice& lattice);

/// The triangle with these control points as one of a higher degree, exactly (Farin 1993): each control point is a mean
/// of some before.
std::vector<Vec3> raised_to(int degree, const Lattice& lattice, const std::vector<Vec3>& control);

/// De Casteljau along edge (a, b) with parameter 1/2: every row of points that differ by moves from a to b is a
/// polynomial in one variable of its own. Coefficients are `width` numbers side by side, in `blocks` lists of all.
void halve_blocks(const Lattice& lattice, std::size_t blocks, std::size_t width, const double* c, int a, int b,
                  double* first, double* second);
/// The polynomial on the two halves that the middle of edge (a, b) makes: first the one that keeps corner a.
std::pair<std::vector<double>, std::vector<double>> halve(const Lattice& lattice, const std::vector<double>& c, int a,
                                                          int b);
std::pair<std::vector<Vec3>, std::vector<Vec3>> halve(const Lattice& lattice, const std::vector<Vec3>& c, int a, int b);

}  // namespace mq::elements

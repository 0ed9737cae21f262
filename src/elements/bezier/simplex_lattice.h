// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

/// Curvilinear meshes after Dey, O'Bara, Shephard 1999.
namespace mq::elements {

/// Barycentric exponents or coordinates; entries past the simplex' dimension are zero.
using Exponents = std::array<int, 4>;
using Barycentric = std::array<double, 4>;

/// Highest order of an element that the tables hold.
constexpr int kMaxOrder = 5;
/// Highest degree of a polynomial in the tables: the Jacobian of a hexahedron of order 5 has it along each axis.
constexpr int kMaxDegree = 14;

/// The points of a simplex at which polynomials of one degree have their coefficients: all sums of `dimension` + 1
/// exponents that make up the degree. Nodes, Bezier control points and Bernstein coefficients are stored in its order.
class Lattice {
  public:
    /// The table of a dimension 1 (edge), 2 (triangle) or 3 (tetrahedron). @throws InvalidInput out of range.
    static const Lattice& of(int dimension, int degree);

    int dimension() const { return dimension_; }
    int degree() const { return degree_; }
    int size() const { return static_cast<int>(points_.size()); }
    const Exponents& exponents(int i) const { return points_[static_cast<std::size_t>(i)]; }
    int index(const Exponents& e) const { return index_[static_cast<std::size_t>(slot(e))]; }
    int corner(int k) const { return corners_[static_cast<std::size_t>(k)]; }
    /// n! / (e0! e1! e2! e3!), the factor of the Bernstein polynomial of point i.
    double multinomial(int i) const { return multinomials_[static_cast<std::size_t>(i)]; }
    /// The place of point i's node: its exponents divided by the degree.
    Barycentric node(int i) const;
    /// The number of corners of the smallest sub-simplex that holds point i.
    int carriers(int i) const;

    Lattice(int dimension, int degree);

  private:
    int slot(const Exponents& e) const { return (e[1] * (degree_ + 1) + e[2]) * (degree_ + 1) + e[3]; }

    int dimension_;
    int degree_;
    std::vector<Exponents> points_;
    std::vector<int> index_;
    std::array<int, 4> corners_{};
    std::vector<double> multinomials_;
};

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <utility>

#include "elements/bezier/simplex_lattice.h"

namespace mq::elements {

/// A sub-simplex of the reference simplex by its corners; entries beyond its dimension are unused.
using SimplexPart = std::array<Barycentric, 4>;
/// The whole reference simplex.
constexpr SimplexPart kWholeSimplex{
    {{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0}}};

Barycentric middle_of(const Barycentric& a, const Barycentric& b);

double squared_length(const SimplexPart& part, const std::pair<int, int>& edge);
/// Whether a squared length exceeds another by more than rounding.
bool is_longer(double squared, double than_squared);

/// The ends of the edge that is longest in barycentric coordinates; of edges equal up to rounding the first.
std::pair<int, int> longest_edge(const SimplexPart& part, int dimension);

/// The two halves that the middle of edge (a, b) makes: first the one that keeps corner a.
std::pair<SimplexPart, SimplexPart> halve(const SimplexPart& part, int a, int b);

}  // namespace mq::elements

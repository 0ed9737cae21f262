// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/minimum_search.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace mq::elements {

double largest_magnitude(const std::vector<double>& coefficients) {
    double most = 0.0;
    for (const double c : coefficients) {
        most = std::max(most, std::abs(c));
    }
    return most;
}

MinimumSearch::MinimumSearch(const ProductLattice& lattice, double rounding, std::vector<double> coefficients)
    : lattice_(lattice),
      rounding_(rounding),
      halving_rounding_(0.5 * lattice.highest_degree() * std::numeric_limits<double>::epsilon() *
                        largest_magnitude(coefficients)) {
    push({0.0, 0, 0, std::move(coefficients), {kWholeSimplex, kWholeSimplex, kWholeSimplex}});
}

void MinimumSearch::step() {
    std::pop_heap(heap_.begin(), heap_.end());
    const Piece piece = std::move(heap_.back());
    heap_.pop_back();
    int longest = 0;
    std::pair<int, int> edge;
    double most = -1.0;
    for (int f = 0; f < lattice_.factors(); ++f) {
        const SimplexPart& of_factor = piece.part[static_cast<std::size_t>(f)];
        const std::pair<int, int> candidate = longest_edge(of_factor, lattice_.factor(f).dimension());
        const double length = squared_length(of_factor, candidate);
        if (lattice_.factor(f).degree() > 0 && is_longer(length, most)) {
            most = length;
            longest = f;
            edge = candidate;
        }
    }
    const auto [a, b] = edge;
    const auto f = static_cast<std::size_t>(longest);
    auto [first, second] = lattice_.halve(piece.coefficients, longest, a, b);
    std::pair<ProductPart, ProductPart> parts{piece.part, piece.part};
    std::tie(parts.first[f], parts.second[f]) = halve(piece.part[f], a, b);
    push({0.0, 0, piece.halvings + 1, std::move(first), parts.first});
    push({0.0, 0, piece.halvings + 1, std::move(second), parts.second});
}

void MinimumSearch::push(Piece piece) {
    piece.serial = serial_++;
    piece.low = *std::min_element(piece.coefficients.begin(), piece.coefficients.end()) - rounding_ -
                piece.halvings * halving_rounding_;
    for (std::size_t k = 0; k < lattice_.corners().size(); ++k) {
        const double at_corner = piece.coefficients[static_cast<std::size_t>(lattice_.corners()[k])];
        if (at_corner < high_) {
            high_ = at_corner;
            halvings_ = piece.halvings;
            const ProductLattice::Indices& corner = lattice_.corner_of_factors(static_cast<int>(k));
            for (std::size_t f = 0; f < static_cast<std::size_t>(lattice_.factors()); ++f) {
                at_[f] = piece.part[f][static_cast<std::size_t>(corner[f])];
            }
        }
    }
    // The minimum cannot be in it; the piece in which `high_` is attained stays.
    if (piece.low > high_) {
        return;
    }
    heap_.push_back(std::move(piece));
    std::push_heap(heap_.begin(), heap_.end());
}

}  // namespace mq::elements

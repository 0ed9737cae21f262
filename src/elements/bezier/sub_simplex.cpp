// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/sub_simplex.h"

#include <cstddef>

namespace mq::elements {

namespace {

/// Factor by which a squared length must exceed another to count as longer: equal lengths differ by rounding only.
constexpr double kLonger = 1.0 + 1e-9;

double squared_distance(const Barycentric& a, const Barycentric& b) {
    double square = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        square += (a[k] - b[k]) * (a[k] - b[k]);
    }
    return square;
}

}  // namespace

Barycentric middle_of(const Barycentric& a, const Barycentric& b) {
    return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]), 0.5 * (a[3] + b[3])};
}

double squared_length(const SimplexPart& part, const std::pair<int, int>& edge) {
    return squared_distance(part[static_cast<std::size_t>(edge.first)], part[static_cast<std::size_t>(edge.second)]);
}

bool is_longer(double squared, double than_squared) {
    return squared > than_squared * kLonger;
}

std::pair<int, int> longest_edge(const SimplexPart& part, int dimension) {
    std::pair<int, int> longest{0, 1};
    double most = -1.0;
    for (int a = 0; a <= dimension; ++a) {
        for (int b = a + 1; b <= dimension; ++b) {
            const double square =
                squared_distance(part[static_cast<std::size_t>(a)], part[static_cast<std::size_t>(b)]);
            if (is_longer(square, most)) {
                most = square;
                longest = {a, b};
            }
        }
    }
    return longest;
}

std::pair<SimplexPart, SimplexPart> halve(const SimplexPart& part, int a, int b) {
    const auto ka = static_cast<std::size_t>(a);
    const auto kb = static_cast<std::size_t>(b);
    std::pair<SimplexPart, SimplexPart> halves{part, part};
    halves.first[kb] = halves.second[ka] = middle_of(part[ka], part[kb]);
    return halves;
}

}  // namespace mq::elements

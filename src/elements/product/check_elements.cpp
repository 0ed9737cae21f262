// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/check_elements.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.h"
#include "base/parallel.h"
#include "elements/bezier/minimum_search.h"
#include "elements/bezier/validity.h"

namespace mq::curve {

namespace {

/// A product of simplices for MinimumSearch: each piece is halved across the longest edge of all its factors.
class ProductDomain {
  public:
    using Part = ProductPart;
    using Half = std::pair<std::vector<double>, Part>;

    ProductDomain(const ProductLattice& lattice, double rounding, double halving_rounding)
        : lattice_(lattice), rounding_(rounding), halving_rounding_(halving_rounding) {}

    Part whole() const { return {kWholeSimplex, kWholeSimplex, kWholeSimplex}; }
    int corners() const { return static_cast<int>(lattice_.corners().size()); }
    int corner(int k) const { return lattice_.corners()[static_cast<std::size_t>(k)]; }
    ProductPoint place(const Part& part, int k) const {
        ProductPoint point{};
        for (std::size_t f = 0; f < static_cast<std::size_t>(lattice_.factors()); ++f) {
            point[f] = part[f][static_cast<std::size_t>(lattice_.corner_of_factors(k)[f])];
        }
        return point;
    }
    double rounding() const { return rounding_; }
    double halving_rounding() const { return halving_rounding_; }

    std::pair<Half, Half> halve(const std::vector<double>& coefficients, const Part& part) const {
        int longest = 0;
        std::pair<int, int> edge;
        double most = -1.0;
        for (int f = 0; f < lattice_.factors(); ++f) {
            const SimplexPart& of_factor = part[static_cast<std::size_t>(f)];
            const std::pair<int, int> candidate = longest_edge(of_factor, lattice_.factor(f).dimension());
            const double length = squared_length(of_factor, candidate);
            if (lattice_.factor(f).degree() > 0 && is_longer(length, most)) {
                most = length;
                longest = f;
                edge = candidate;
            }
        }
        const auto f = static_cast<std::size_t>(longest);
        auto [first, second] = lattice_.halve(coefficients, longest, edge.first, edge.second);
        std::pair<Half, Half> halves{{std::move(first), part}, {std::move(second), part}};
        std::tie(halves.first.second[f], halves.second.second[f]) = curve::halve(part[f], edge.first, edge.second);
        return halves;
    }

  private:
    const ProductLattice& lattice_;
    double rounding_;
    double halving_rounding_;
};

using Search = MinimumSearch<ProductDomain>;

/// Most pieces for a bound and for a sign; the pieces of large polynomials must fit into memory, too.
int most_pieces(const ProductForm& form, int otherwise) {
    constexpr std::size_t kMostNumbers = 16'000'000;
    return std::min(otherwise, static_cast<int>(kMostNumbers / form.coefficients.size()));
}

/// Narrows the bounds of the minimum to the accuracy and, if `sign` is set, until the sign is known.
void narrow(Search& search, const ProductForm& form, double scale, bool sign) {
    constexpr int kPieces = 4000;
    constexpr int kPiecesForSign = 40000;
    const double accuracy = std::max(kElementAccuracy * scale, 4.0 * form.rounding);
    const double nearly_zero = std::max(form.rounding, kValidityTolerance * scale);
    const auto sign_known = [&] { return !sign || search.low() > 0.0 || search.high() <= nearly_zero; };
    while (!sign_known() && search.pieces() < most_pieces(form, kPiecesForSign)) {
        search.step();
    }
    while (search.high() - search.low() > accuracy && search.pieces() < most_pieces(form, kPieces)) {
        search.step();
    }
}

double lower(double x) {
    return std::max(-1.0, std::nextafter(x, -2.0));
}

double upper(double x) {
    return std::min(1.0, std::nextafter(x, 2.0));
}

/// An interval that holds a number.
struct Range {
    double low;
    double high;
};

/// The range of min J / max |J|.
Range ratio_of(const Range& least, const Range& most) {
    const Range scale{std::max(most.low, -least.high), std::max(most.high, -least.low)};
    Range ratio{-1.0, 1.0};
    if (least.low >= 0.0) {
        ratio.low = lower(least.low / scale.high);
    } else if (scale.low > 0.0) {
        ratio.low = lower(least.low / scale.low);
    }
    if (least.high <= 0.0) {
        ratio.high = upper(least.high / scale.high);
    } else if (scale.low > 0.0) {
        ratio.high = upper(least.high / scale.low);
    }
    return ratio;
}

void require_sound(const std::vector<Vec3>& nodes, const std::vector<std::int32_t>& connectivity, int width) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].allFinite()) {
            throw InvalidInput("node " + std::to_string(i) + " has a coordinate that is not a finite number");
        }
    }
    const auto per_element = static_cast<std::size_t>(width);
    if (connectivity.size() % per_element != 0) {
        throw InvalidInput(std::to_string(connectivity.size()) + " node numbers do not make whole elements of " +
                           std::to_string(width) + " nodes");
    }
    for (std::size_t i = 0; i < connectivity.size(); ++i) {
        if (connectivity[i] < 0 || static_cast<std::size_t>(connectivity[i]) >= nodes.size()) {
            throw InvalidInput("element " + std::to_string(i / per_element) + " names node " +
                               std::to_string(connectivity[i]) + ", but there are " + std::to_string(nodes.size()) +
                               " nodes, counted from 0");
        }
    }
}

}  // namespace

ElementVerdict judge(const ProductForm& jacobian) {
    ElementVerdict result;
    const double scale = largest_magnitude(jacobian.coefficients);
    for (const double c : jacobian.coefficients) {
        if (!std::isfinite(c)) {
            return result;
        }
    }
    const double halving = halving_error(jacobian.lattice->highest_degree(), jacobian.coefficients);
    const ProductDomain domain(*jacobian.lattice, jacobian.rounding, halving);
    Search least(domain, jacobian.coefficients);
    narrow(least, jacobian, scale, true);
    std::vector<double> negative = jacobian.coefficients;
    for (double& c : negative) {
        c = -c;
    }
    const bool fails = least.high() <= jacobian.rounding;
    Search most(domain, std::move(negative));
    narrow(most, jacobian, scale, fails);
    const Range ratio = ratio_of({least.low(), least.high_bound()}, {-most.high_bound(), -most.low()});
    result.low = ratio.low;
    result.high = ratio.high;
    result.at = least.at();
    if (least.low() > 0.0) {
        result.verdict = Verdict::Valid;
    } else if (fails) {
        result.verdict = most.low() > 0.0 ? Verdict::Inverted : Verdict::Folded;
    }
    return result;
}

ElementVerdicts check_elements(ElementKind kind, int order, const std::vector<Vec3>& nodes,
                               const std::vector<std::int32_t>& connectivity, int nodes_per_element,
                               Progress* progress) {
    // Elements in one parallel task: enough that starting a task costs little.
    constexpr int kChunk = 64;
    const ElementJacobian jacobian(kind, order, nodes_per_element);
    require_sound(nodes, connectivity, nodes_per_element);
    const auto width = static_cast<std::size_t>(nodes_per_element);
    const std::size_t count = connectivity.size() / width;
    ElementVerdicts result{std::vector<double>(count), std::vector<double>(count), std::vector<std::uint8_t>(count)};
    const int chunks = static_cast<int>((count + kChunk - 1) / kChunk);
    std::atomic<int> done{0};
    parallel_for(chunks, [&](int chunk) {
        std::vector<Vec3> of_element(width);
        const std::size_t begin = static_cast<std::size_t>(chunk) * kChunk;
        for (std::size_t e = begin; e < std::min(begin + kChunk, count); ++e) {
            check_cancelled(progress);
            for (std::size_t i = 0; i < width; ++i) {
                of_element[i] = nodes[static_cast<std::size_t>(connectivity[e * width + i])];
            }
            const ElementVerdict verdict = judge(jacobian.of(of_element));
            result.low[e] = verdict.low;
            result.high[e] = verdict.high;
            result.verdict[e] = static_cast<std::uint8_t>(verdict.verdict);
        }
        if (progress != nullptr) {
            progress->advance(static_cast<double>(++done) / chunks);
        }
    });
    return result;
}

}  // namespace mq::curve

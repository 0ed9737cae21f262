// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/check_elements.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/bezier/minimum_search.h"
#include "elements/bezier/validity.h"

namespace mq::elements {

namespace {

/// Most pieces for a bound and for a sign; the pieces of large polynomials must fit into memory, too.
int most_pieces(const JacobianForm& form, int otherwise) {
    constexpr std::size_t kMostNumbers = 16'000'000;
    return std::min(otherwise, static_cast<int>(kMostNumbers / form.coefficients.size()));
}

/// Narrows the bounds of the minimum to the accuracy and, if `sign` is set, until the sign is known.
void narrow(MinimumSearch& search, const JacobianForm& form, double scale, bool sign) {
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
            throw InvalidInput(phrases::kNodeNotFinite, {{"count", i}});
        }
    }
    const auto per_element = static_cast<std::size_t>(width);
    if (connectivity.size() % per_element != 0) {
        throw InvalidInput(phrases::kNotWholeElements, {{"count", connectivity.size()}, {"count2", width}});
    }
    for (std::size_t i = 0; i < connectivity.size(); ++i) {
        if (connectivity[i] < 0 || static_cast<std::size_t>(connectivity[i]) >= nodes.size()) {
            throw InvalidInput(phrases::kNoSuchNode,
                               {{"count", i / per_element}, {"count2", connectivity[i]}, {"count3", nodes.size()}});
        }
    }
}

}  // namespace

ElementVerdict judge(const JacobianForm& jacobian) {
    ElementVerdict result;
    const double scale = largest_magnitude(jacobian.coefficients);
    for (const double c : jacobian.coefficients) {
        if (!std::isfinite(c)) {
            return result;
        }
    }
    MinimumSearch least(*jacobian.lattice, jacobian.rounding, jacobian.coefficients);
    narrow(least, jacobian, scale, true);
    std::vector<double> negative = jacobian.coefficients;
    for (double& c : negative) {
        c = -c;
    }
    const bool fails = least.high() <= jacobian.rounding;
    MinimumSearch most(*jacobian.lattice, jacobian.rounding, std::move(negative));
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

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/patch_pieces.h"

#include <algorithm>
#include <utility>

#include "elements/bezier/bernstein.h"

namespace mq::curve {

using elements::Exponents;
using elements::Lattice;

namespace {

/// The control point whose exponent of `corner` is larger by one.
const Vec3& raised(const Lattice& lattice, const std::vector<Vec3>& control, Exponents e, int corner) {
    ++e[static_cast<std::size_t>(corner)];
    return control[static_cast<std::size_t>(lattice.index(e))];
}

}  // namespace

PatchPiece::PatchPiece(const Lattice& lattice, std::vector<Vec3> points, const elements::SimplexPart& in_patch)
    : control(std::move(points)), part(in_patch) {
    for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = control[static_cast<std::size_t>(lattice.corner(static_cast<int>(k)))];
    }
    for (int i = 0; i < lattice.size(); ++i) {
        const Vec3& p = control[static_cast<std::size_t>(i)];
        const elements::Barycentric at = lattice.node(i);
        box.add(p);
        bend = std::max(bend, (p - at[0] * corners[0] - at[1] * corners[1] - at[2] * corners[2]).norm());
    }
    size = (box.high - box.low).norm();
}

PatchPieces::PatchPieces(const Lattice& lattice, const std::vector<Vec3>& control) : lattice_(&lattice) {
    pieces_.emplace_back(lattice, control, elements::kWholeSimplex);
}

std::int32_t PatchPieces::halve(std::int32_t piece, int a, int b) {
    PatchPiece& whole = pieces_[static_cast<std::size_t>(piece)];
    std::int32_t& first = whole.halves[static_cast<std::size_t>(3 - a - b)];
    if (first < 0) {
        first = static_cast<std::int32_t>(pieces_.size());
        auto [keeps_a, keeps_b] = elements::halve(*lattice_, whole.control, std::min(a, b), std::max(a, b));
        const auto [part_a, part_b] = elements::halve(whole.part, std::min(a, b), std::max(a, b));
        pieces_.emplace_back(*lattice_, std::move(keeps_a), part_a);
        pieces_.emplace_back(*lattice_, std::move(keeps_b), part_b);
    }
    return first;
}

std::int32_t PatchPieces::halve(std::int32_t piece) {
    const auto [a, b] = elements::longest_edge(pieces_[static_cast<std::size_t>(piece)].part, 2);
    return halve(piece, a, b);
}

void add_transversals(const Lattice& lattice, const std::vector<Vec3>& control, int corner, double sign,
                      std::vector<Vec3>& vectors) {
    const Lattice& lower = Lattice::of(2, lattice.degree() - 1);
    for (int i = 0; i < lower.size(); ++i) {
        const Exponents& e = lower.exponents(i);
        const Vec3& to = raised(lattice, control, e, corner);
        vectors.push_back(sign * (to - raised(lattice, control, e, (corner + 1) % 3)));
        vectors.push_back(sign * (to - raised(lattice, control, e, (corner + 2) % 3)));
    }
}

void add_tangents(const Lattice& lattice, const std::vector<Vec3>& control, int a, int b, double sign,
                  std::vector<Vec3>& vectors) {
    const int below = lattice.degree() - 1;
    for (int i = 0; i <= below; ++i) {
        Exponents e{};
        e[static_cast<std::size_t>(a)] = below - i;
        e[static_cast<std::size_t>(b)] = i;
        vectors.push_back(sign * (raised(lattice, control, e, b) - raised(lattice, control, e, a)));
    }
}

}  // namespace mq::curve

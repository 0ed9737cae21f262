// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/inverted_loops.h"

#include <algorithm>
#include <cmath>

#include "triangulate/initial/tuning.h"

namespace mq::triangulate {

namespace {

constexpr int kSamples = 4;  // samples in each piece; a quarter of a piece is nearly straight
// A ratio of area to length^2 below this is rounding: chords coincide, or curves enclose no area.
constexpr double kNothing = 1e-9;

struct Outline {
    std::vector<int> pieces;
    double area = 0.0;  // signed area between the chords, mm^2
    double length = 0.0;

    bool narrow() const {
        return 4.0 * M_PI * std::abs(area) < InitialTuning::kNarrowLoop * length * length &&
               std::abs(area) > kNothing * length * length;
    }
};

std::vector<Outline> outlines_of(const FaceBoundary& border) {
    std::vector<Outline> loops;
    const Vec2 origin = border.sites.empty() ? Vec2(0.0, 0.0) : border.scaled(border.sites.front().uv);
    for (int k = 0; k < static_cast<int>(border.pieces.size()); ++k) {
        const FaceBoundary::Piece& piece = border.pieces[k];
        loops.resize(std::max<std::size_t>(loops.size(), piece.loop + 1));
        const Vec2 from = border.scaled(border.sites[piece.from].uv) - origin;
        const Vec2 to = border.scaled(border.sites[piece.to].uv) - origin;
        Outline& loop = loops[piece.loop];
        loop.pieces.push_back(k);
        loop.area += 0.5 * cross(from, to);
        loop.length += (to - from).norm();
    }
    return loops;
}

// Whether curves of this size can change the sign of the area between the chords. Parabolas through the middles of the
// pieces tell how large they are, within a factor of two.
bool may_be_inverted(const Outline& loop, const FaceBoundary& border, const std::vector<std::optional<Vec2>>& middles) {
    double beside = 0.0;
    for (const int k : loop.pieces) {
        if (middles[k]) {
            const Vec2 from = border.scaled(border.sites[border.pieces[k].from].uv);
            const Vec2 to = border.scaled(border.sites[border.pieces[k].to].uv);
            beside += 2.0 / 3.0 * std::abs(cross(*middles[k] - from, to - from));
        }
    }
    return 2.0 * beside >= std::abs(loop.area);
}

// Returns the signed area between the curve of a piece and its chord; added to the area between the chords it gives
// the area between the curves.
double area_beside(geometry::Oracle& oracle, const EdgeDiscretisation& chains, const FaceBoundary& border,
                   const FaceBoundary::Piece& piece) {
    if (piece.collapsed()) {
        return 0.0;
    }
    const geometry::EdgeUse& use = oracle.topology().uses[piece.use];
    const EdgePolyline& chain = chains.chain(use.edge);
    const double start = chain.t[use.forward ? piece.index : piece.index + 1];
    const double end = chain.t[use.forward ? piece.index + 1 : piece.index];
    geometry::Engine::Batch batch;
    for (int i = 1; i < kSamples; ++i) {
        batch.push_back(geometry::Query::use_on_face(piece.use, start + (end - start) * i / kSamples));
    }
    const Vec2 from = border.scaled(border.sites[piece.from].uv);
    Vec2 last(0.0, 0.0);
    double area = 0.0;
    for (const geometry::Answer& answer : oracle.ask(std::move(batch))) {
        if (!answer.found()) {
            return 0.0;
        }
        const Vec2 here = border.scaled(Vec2(answer.u, answer.v)) - from;
        area += 0.5 * cross(last, here);
        last = here;
    }
    return area + 0.5 * cross(last, border.scaled(border.sites[piece.to].uv) - from);
}

}  // namespace

std::vector<int> coarse_pieces_of_inverted_loops(geometry::Oracle& oracle, const EdgeDiscretisation& chains,
                                                 const FaceBoundary& border,
                                                 const std::vector<std::optional<Vec2>>& middles) {
    std::vector<int> coarse;
    for (const Outline& loop : outlines_of(border)) {
        if (!loop.narrow() || !may_be_inverted(loop, border, middles)) {
            continue;
        }
        std::vector<double> beside;
        double area = loop.area;
        double most = 0.0;
        for (const int k : loop.pieces) {
            beside.push_back(area_beside(oracle, chains, border, border.pieces[k]));
            area += beside.back();
            most = std::max(most, std::abs(beside.back()));
        }
        if (area * loop.area > 0.0 || std::abs(area) <= kNothing * loop.length * loop.length) {
            continue;
        }
        for (std::size_t i = 0; i < beside.size(); ++i) {
            if (2.0 * std::abs(beside[i]) >= most) {
                coarse.push_back(loop.pieces[i]);
            }
        }
    }
    return coarse;
}

}  // namespace mq::triangulate

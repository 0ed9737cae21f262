// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/trimmed_face_distances.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/segment_distance.h"

namespace mq::geometry {

void TrimmedFaceDistances::divide_edges_of(int face) {
    // Pieces of an edge and of each of its polynomials: the arc over one piece is nearly straight.
    constexpr int kPieces = 16;
    constexpr int kPiecesOfSpan = 4;
    std::vector<Piece>& pieces = pieces_[face];
    for (const int e : session_.topology().edges_of(face)) {
        const Edge& edge = session_.topology().edges[static_cast<std::size_t>(e)];
        if (edge.degenerate) {
            continue;
        }
        const int count = std::max(kPieces, kPiecesOfSpan * static_cast<int>(edge.spans.bounds.size()));
        const auto at = [&](int i) { return edge.t0 + (edge.t1 - edge.t0) * i / count; };
        Engine::Batch batch;
        for (int i = 0; i <= count; ++i) {
            batch.push_back(Query::edge_point(e, at(i)));
        }
        const Engine::Answers points = session_.ask(std::move(batch));
        for (int i = 0; i < count; ++i) {
            const Answer& from = points[static_cast<std::size_t>(i)];
            const Answer& to = points[static_cast<std::size_t>(i) + 1];
            if (from.found() && to.found()) {
                pieces.push_back({e, at(i), at(i + 1), from.point, to.point});
            }
        }
    }
}

double TrimmedFaceDistances::distance(Answerer& answerer, const Place& place) const {
    constexpr double kBorder = 1e-7;     // mm: OpenCASCADE's least distance
    constexpr std::size_t kNearest = 4;  // pieces that are searched
    const Answer nearest =
        answerer.answer(place.guess ? Query::face_nearest(place.face, place.point, place.guess->x(), place.guess->y())
                                    : Query::face_nearest_global(place.face, place.point));
    if (nearest.found()) {
        const Answer side = answerer.answer(Query::face_contains(place.face, nearest.u, nearest.v, kBorder));
        if (side.found() && side.side > 0) {
            return nearest.distance;
        }
    }
    const std::vector<Piece>& pieces = pieces_.at(place.face);
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        order.emplace_back(distance_to_segment(place.point, pieces[i].from, pieces[i].to), i);
    }
    const std::size_t count = std::min(kNearest, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < count; ++k) {
        const Piece& piece = pieces[order[k].second];
        const Answer on = answerer.answer(
            Query::edge_nearest(piece.edge, place.point, 0.5 * (piece.low + piece.high), piece.low, piece.high));
        least = std::min({least, on.found() ? on.distance : least, (piece.from - place.point).norm(),
                          (piece.to - place.point).norm()});
    }
    if (count > 0) {
        return least;
    }
    return nearest.found() ? nearest.distance : -1.0;
}

std::vector<double> TrimmedFaceDistances::measure(const std::vector<Place>& places) {
    for (const Place& place : places) {
        if (pieces_.count(place.face) == 0) {
            divide_edges_of(place.face);
        }
    }
    std::vector<double> result(places.size());
    session_.for_chunks(places.size(), [&](Answerer& answerer, std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            result[i] = distance(answerer, places[i]);
        }
    });
    return result;
}

}  // namespace mq::geometry

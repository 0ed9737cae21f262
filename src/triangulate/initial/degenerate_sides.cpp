// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/degenerate_sides.h"

#include <cmath>
#include <map>
#include <numeric>

#include "base/angle.h"

namespace mq::triangulate {

namespace {

using Piece = FaceBoundary::Piece;
using VertexUse = FaceMesh::VertexUse;

constexpr int kNormalSamples = 64;            // Samples along a collapsed side at which normals are compared.
constexpr double kMostTurn = 60.0 * kDegree;  // Radians: largest turn of the normal along one piece.
// Distance of the samples from the side, as a fraction of the size of the domain: on the side itself there is no
// normal.
constexpr double kInside = 1e-3;
constexpr double kDomainRounding = 1e-9;  // rounding, as a fraction of the size of the domain

// Returns the parameter along which the side runs; -1: neither, where points between its ends would not lie on it
// exactly. Removes a difference by rounding between the ends in the other parameter.
int direction_of(const geometry::Face& face, const VertexUse& from, VertexUse& to) {
    int direction = -1;
    for (int i = 0; i < 2; ++i) {
        const double range = face.high[i] - face.low[i];
        if (std::abs(to.uv[1 - i] - from.uv[1 - i]) <= kDomainRounding * (face.high[1 - i] - face.low[1 - i]) &&
            std::abs(to.uv[i] - from.uv[i]) > kDomainRounding * range) {
            direction = i;
            to.uv[1 - i] = from.uv[1 - i];
        }
    }
    return direction;
}

Vec2 between(const VertexUse& from, const VertexUse& to, double share) {
    return from.uv + share * (to.uv - from.uv);
}

// Returns the points at which the side is divided, as fractions of its length.
std::vector<double> places(geometry::Oracle& oracle, int face, const VertexUse& from, const VertexUse& to,
                           int direction) {
    const geometry::Face& data = oracle.topology().faces[face];
    const int across = 1 - direction;
    const double range = data.high[across] - data.low[across];
    const double inwards = from.uv[across] < 0.5 * (data.low[across] + data.high[across]) ? kInside : -kInside;
    geometry::Engine::Batch batch;
    for (int i = 0; i <= kNormalSamples; ++i) {
        Vec2 uv = between(from, to, static_cast<double>(i) / kNormalSamples);
        uv[across] += inwards * range;
        batch.push_back(geometry::Query::face_point(face, uv.x(), uv.y()));
    }
    const geometry::Engine::Answers answers = oracle.ask(std::move(batch));
    std::vector<double> result;
    double turn = 0.0;
    for (int i = 1; i < kNormalSamples; ++i) {
        if (!answers[i].found() || !answers[i - 1].found() || !answers[i + 1].found()) {
            continue;
        }
        turn += angle_between(answers[i - 1].normal, answers[i].normal);
        if (turn + angle_between(answers[i].normal, answers[i + 1].normal) > kMostTurn) {
            result.push_back(static_cast<double>(i) / kNormalSamples);
            turn = 0.0;
        }
    }
    return result;
}

int add_site(FaceBoundary& border, VertexUse site, const Vec2& uv) {
    site.uv = uv;
    border.sites.push_back(site);
    return static_cast<int>(border.sites.size()) - 1;
}

}  // namespace

std::vector<int> divide_degenerate_sides(geometry::Oracle& oracle, int face, FaceBoundary& border) {
    std::map<int, int> apex_of;  // by site on a divided side
    std::vector<Piece> pieces;
    pieces.reserve(border.pieces.size());
    for (const Piece& piece : border.pieces) {
        const VertexUse from = border.sites[piece.from];
        VertexUse to = border.sites[piece.to];
        const bool apex = piece.collapsed() && from.vertex == to.vertex;
        const int direction = apex ? direction_of(oracle.topology().faces[face], from, to) : -1;
        const std::vector<double> shares =
            direction < 0 ? std::vector<double>() : places(oracle, face, from, to, direction);
        Piece rest = piece;
        std::vector<int> on_side{piece.from, piece.to};
        for (const double share : shares) {
            on_side.push_back(add_site(border, from, between(from, to, share)));
            Piece part = rest;
            part.to = rest.from = on_side.back();
            pieces.push_back(part);
        }
        if (!shares.empty()) {
            border.sites[piece.to] = to;
            const int middle = on_side[2 + shares.size() / 2];
            const bool pointed = !(from.normal.squaredNorm() > 0.0) || !(to.normal.squaredNorm() > 0.0);
            border.sites[middle].normal = Vec3::Zero();
            for (std::size_t i = 0; i < on_side.size(); ++i) {
                const bool near_start = i == 0 || (i > 1 && shares[i - 2] < 0.5);
                apex_of[on_side[i]] = pointed ? middle : near_start ? piece.from : piece.to;
            }
        }
        pieces.push_back(rest);
    }
    border.pieces = std::move(pieces);
    border.find_collapsed_runs();
    std::vector<int> stands_for(border.sites.size());
    std::iota(stands_for.begin(), stands_for.end(), 0);
    for (const auto& [site, one] : apex_of) {
        stands_for[site] = one;
    }
    return stands_for;
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sampling/face_sampler.h"

#include <algorithm>
#include <cmath>

namespace mq::triangulate {

using geometry::Answer;
using geometry::Engine;
using geometry::Query;

FaceSampler::FaceSampler(const SamplingContext& context, int face, const FaceBoundary& border, double closest)
    : context_(context), face_(face), closest_(closest) {
    for (const VertexUse& site : border.sites) {
        index_.add(site.point, spacing_at(site.point));
        half_piece_.push_back(0.0);
    }
    for (const FaceBoundary::Piece& piece : border.pieces) {
        const Vec3& a = border.sites[piece.from].point;
        const Vec3& b = border.sites[piece.to].point;
        const double length = (b - a).norm();
        if (length > 0.0) {
            index_.add(0.5 * (a + b), length);
            half_piece_.push_back(0.5 * length);
        }
    }
}

double FaceSampler::spacing_at(const Vec3& local) const {
    return context_.field.at(context_.grid.to_shape(local), context_.bounds.most);
}

Vec2 FaceSampler::into_bounds(Vec2 uv) const {
    const geometry::Face& face = context_.session.topology().faces[face_];
    for (int i = 0; i < 2; ++i) {
        const double period = face.period[i];
        if (period > 0.0 && (uv[i] < face.low[i] || uv[i] > face.high[i])) {
            uv[i] -= period * std::floor((uv[i] - face.low[i]) / period);
        }
    }
    return uv;
}

bool FaceSampler::crowded(const Vec3& point, double spacing) const {
    const double reach = closest_ * spacing;
    return index_.any_near(point, reach, [&](int i) {
        const double limit = half_piece_[i] > 0.0 ? half_piece_[i] : reach;
        return (index_.point(i) - point).squaredNorm() < limit * limit;
    });
}

void FaceSampler::balls_around(const Vec3& point, double radius, double spacing,
                               std::vector<VoidSearch::Ball>& balls) const {
    balls.clear();
    const double reach = radius + closest(spacing);
    index_.any_near(point, reach, [&](int i) {
        const double limit = half_piece_[i] > 0.0 ? radius + half_piece_[i] : reach;
        if ((index_.point(i) - point).squaredNorm() < limit * limit) {
            balls.push_back({index_.point(i), half_piece_[i]});
        }
        return false;
    });
}

std::vector<std::optional<FaceSampler::Candidate>> FaceSampler::candidates(const std::vector<Vec2>& uvs) const {
    Engine::Batch batch;
    for (const Vec2& uv : uvs) {
        batch.push_back(Query::face_curvatures(face_, uv.x(), uv.y()));
    }
    const Engine::Answers answers = context_.session.ask(std::move(batch));
    std::vector<std::optional<Candidate>> found(uvs.size());
    std::vector<std::size_t> roomy;
    Engine::Batch places;
    for (std::size_t i = 0; i < uvs.size(); ++i) {
        const Answer& a = answers[i];
        if (a.status != geometry::Status::Ok) {
            continue;
        }
        const double spacing = context_.spacing_at(a);
        found[i] = Candidate{{-1, uvs[i], a.normal, context_.grid.snap(a.point)}, spacing, false};
        if (!crowded(found[i]->site.point, spacing)) {
            roomy.push_back(i);
            places.push_back(Query::face_contains(face_, uvs[i].x(), uvs[i].y()));
        }
    }
    const Engine::Answers sides = context_.session.ask(std::move(places));
    for (std::size_t k = 0; k < roomy.size(); ++k) {
        found[roomy[k]]->fits = sides[k].side > 0;
    }
    return found;
}

void FaceSampler::accept(const Candidate& candidate) {
    index_.add(candidate.site.point, candidate.spacing);
    half_piece_.push_back(0.0);
    samples_.push_back(candidate);
}

}  // namespace mq::triangulate

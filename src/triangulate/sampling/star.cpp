// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sampling/star.h"

#include <algorithm>
#include <cmath>

#include "triangulate/sampling/tuning.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Engine;
using geometry::Query;

constexpr int kCorners = 6;  // Corners of a regular hexagon, whose triangles are equilateral.

// A sample whose hexagon has not been drawn yet.
struct Seed {
    FaceSampler::Candidate sample;
    Vec3 towards;  // direction of its first corner
};

// A corner of a hexagon in the tangent plane.
struct Corner {
    std::size_t seed;
    Vec3 point;
};

class Star {
  public:
    Star(const SamplingContext& context, int face, const FaceBoundary& border)
        : sampler_(context, face, border, SamplingTuning::kStarClosest) {
        for (const FaceBoundary::Piece& piece : border.pieces) {
            const FaceSampler::VertexUse& from = border.sites[piece.from];
            const Vec3 along = border.sites[piece.to].point - from.point;
            if (from.normal.squaredNorm() > 0.0 && along.squaredNorm() > 0.0) {
                queue_.push_back({{from, sampler_.spacing_at(from.point), true}, along});
            }
        }
    }

    std::vector<FaceSampler::Candidate> run() {
        for (std::size_t from = 0; from < queue_.size() && !sampler_.full();) {
            sampler_.context().progress.check();
            const std::size_t to = std::min(queue_.size(), from + SamplingTuning::kStarBatch);
            grow(corners(from, to));
            from = to;
        }
        return sampler_.samples();
    }

  private:
    std::vector<Corner> corners(std::size_t from, std::size_t to) const;
    std::vector<Corner> project(const std::vector<Corner>& corners, std::vector<Vec2>& uvs) const;
    void grow(const std::vector<Corner>& corners);

    FaceSampler sampler_;
    std::vector<Seed> queue_;
};

std::vector<Corner> Star::corners(std::size_t from, std::size_t to) const {
    std::vector<Corner> found;
    for (std::size_t i = from; i < to; ++i) {
        const FaceSampler::Candidate& s = queue_[i].sample;
        const Vec3& n = s.site.normal;
        const Vec3 x = (queue_[i].towards - n * n.dot(queue_[i].towards)).normalized();
        const Vec3 y = n.cross(x);
        for (int k = 0; k < kCorners; ++k) {
            const double angle = 2.0 * M_PI * k / kCorners;
            const Vec3 p = s.site.point + s.spacing * (std::cos(angle) * x + std::sin(angle) * y);
            if (!sampler_.crowded(p, SamplingTuning::kStarSlack * s.spacing)) {
                found.push_back({i, p});
            }
        }
    }
    return found;
}

// Returns the corners close to the surface, and their projections.
std::vector<Corner> Star::project(const std::vector<Corner>& corners, std::vector<Vec2>& uvs) const {
    const SamplingContext& context = sampler_.context();
    Engine::Batch batch;
    for (const Corner& c : corners) {
        const Vec2& guess = queue_[c.seed].sample.site.uv;
        batch.push_back(Query::face_nearest(sampler_.face(), context.grid.to_shape(c.point), guess.x(), guess.y()));
    }
    const Engine::Answers answers = context.session.ask(std::move(batch));
    std::vector<Corner> found;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double spacing = queue_[corners[i].seed].sample.spacing;
        const Answer& a = answers[i];
        if (a.found() && a.distance < SamplingTuning::kStarLift * spacing &&
            !sampler_.crowded(context.grid.snap(a.point), SamplingTuning::kStarSlack * spacing)) {
            found.push_back(corners[i]);
            uvs.push_back(sampler_.into_bounds({a.u, a.v}));
        }
    }
    return found;
}

void Star::grow(const std::vector<Corner>& corners) {
    std::vector<Vec2> uvs;
    const std::vector<Corner> near = project(corners, uvs);
    const auto candidates = sampler_.candidates(uvs);
    for (std::size_t i = 0; i < near.size() && !sampler_.full(); ++i) {
        if (!candidates[i] || !candidates[i]->fits) {
            continue;
        }
        FaceSampler::Candidate c = *candidates[i];
        const FaceSampler::Candidate& seed = queue_[near[i].seed].sample;
        const Vec3 back = seed.site.point - c.site.point;
        c.spacing = std::min(c.spacing, seed.spacing + SpacingField::kGrowth * back.norm());
        if (!sampler_.crowded(c.site.point, c.spacing)) {
            sampler_.accept(c);
            queue_.push_back({c, back});
        }
    }
}

}  // namespace

std::vector<FaceSampler::Candidate> sample_star(const SamplingContext& context, int face, const FaceBoundary& border) {
    return Star(context, face, border).run();
}

}  // namespace mq::triangulate

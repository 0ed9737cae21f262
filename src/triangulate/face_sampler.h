// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "geometry/face_border.h"
#include "geometry/session.h"
#include "triangulate/curvature_radius.h"
#include "triangulate/gap_search.h"
#include "triangulate/sample_index.h"

namespace mq::triangulate {

/// What sampling needs to know of the part.
struct SamplingContext {
    geometry::Session& session;
    const SingleGrid& grid;
    const SpacingBounds& bounds;
    const SpacingField& field;
    const Progress& progress;
    std::size_t most_samples = 0;  ///< on one face

    /// r(K), graded, from the answer to Query::face_curvatures.
    double spacing_at(const geometry::Answer& answer) const {
        const bool regular = answer.status == geometry::Status::Ok;
        return field.at(answer.point, regular ? spacing_for(answer.u, bounds) : bounds.most);
    }
};

/// The samples of one face: what the two algorithms of Ruiz et al. have in common. All distances are in space.
class FaceSampler {
  public:
    using Site = geometry::FaceTriangulation::Site;

    /// A point of the surface that may become a sample.
    struct Candidate {
        Site site;
        double spacing = 0.0;  ///< r(K) there, graded
        bool fits = false;     ///< inside the trimmed face, by the geometry engine, and not crowded
    };

    /// The samples of the border count from the start. Two samples may come as close as `closest` times the spacing.
    FaceSampler(const SamplingContext& context, int face, const geometry::FaceBorder& border, double closest);

    /// The points of the surface at (u, v). No value where it has no normal.
    std::vector<std::optional<Candidate>> candidates(const std::vector<Vec2>& uvs) const;
    /// A point of the local frame is too close to a sample, or in the diametral sphere of a piece of the border.
    bool crowded(const Vec3& point, double spacing) const;
    /// The balls that crowd places within `radius` of a point, where the spacing is `spacing` at most.
    void balls_around(const Vec3& point, double radius, double spacing, std::vector<GapSearch::Ball>& balls) const;
    /// How close a sample may come to one where the spacing is such.
    double closest(double spacing) const { return closest_ * spacing; }
    void accept(const Candidate& candidate);
    /// (u, v) of a periodic surface, moved into the bounds of the face.
    Vec2 into_bounds(Vec2 uv) const;
    double spacing_at(const Vec3& local) const;

    int face() const { return face_; }
    const SamplingContext& context() const { return context_; }
    const std::vector<Candidate>& samples() const { return samples_; }
    bool full() const { return samples_.size() >= context_.most_samples; }

  private:
    const SamplingContext& context_;
    int face_;
    double closest_;
    SampleIndex index_;
    std::vector<double> half_piece_;  // by number in the index: of a piece's middle half its length, otherwise 0
    std::vector<Candidate> samples_;
};

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "geometry/session.h"
#include "triangulate/front/void_search.h"
#include "triangulate/initial/face_boundary.h"
#include "triangulate/spacing/point_octree.h"
#include "triangulate/spacing/spacing_field.h"

namespace mq::triangulate {

/// The data of the shape that sampling needs.
struct SamplingContext {
    geometry::Session& session;
    const SinglePrecisionGrid& grid;
    const SpacingBounds& bounds;
    const SpacingField& field;
    const Progress& progress;
    std::size_t most_samples = 0;  ///< limit for one face

    /// Returns the graded spacing r(K), mm, from the answer to Query::face_curvatures.
    double spacing_at(const geometry::Answer& answer) const {
        const bool regular = answer.status == geometry::Status::Ok;
        return field.at(answer.point, regular ? spacing_for(answer.u, bounds) : bounds.most);
    }
};

/// The samples of one face: what the two algorithms have in common of Ruiz et al. All distances are in space, mm.
class FaceSampler {
  public:
    using VertexUse = FaceMesh::VertexUse;

    /// A point of the surface that may become a sample.
    struct Candidate {
        VertexUse site;
        double spacing = 0.0;  ///< graded spacing r(K) at the point, mm
        /// Whether it is inside the trimmed face, by the geometry engine, and not too close to a sample.
        bool fits = false;
    };

    /// The samples of the border are included from the start. Two samples may be as close as `closest` times the
    /// spacing.
    FaceSampler(const SamplingContext& context, int face, const FaceBoundary& border, double closest);

    /// Returns the surface points at (u, v). No value where there is no normal.
    std::vector<std::optional<Candidate>> candidates(const std::vector<Vec2>& uvs) const;
    /// Whether a point of the local frame is too close to a sample, or in the diametral sphere of a piece of the
    /// border.
    bool crowded(const Vec3& point, double spacing) const;
    /// Collects the balls that exclude places within `radius` of a point, where the spacing is at most `spacing`.
    void balls_around(const Vec3& point, double radius, double spacing, std::vector<VoidSearch::Ball>& balls) const;
    /// Returns the least distance between samples for a spacing, mm.
    double closest(double spacing) const { return closest_ * spacing; }
    void accept(const Candidate& candidate);
    /// Moves (u, v) of a periodic surface into the bounds of the face.
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
    PointOctree index_;
    std::vector<double> half_piece_;  // by number in the index: half the length of a piece for its middle, otherwise 0
    std::vector<Candidate> samples_;
};

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sampling.h"

#include <algorithm>
#include <map>

#include "geometry/face_border.h"
#include "geometry/face_rounds.h"
#include "triangulate/edge_samples.h"
#include "triangulate/face_spacing.h"
#include "triangulate/pseudo_delaunay.h"
#include "triangulate/sprinkle.h"
#include "triangulate/star.h"
#include "triangulate/z_curve.h"

namespace mq::triangulate {

namespace {

using geometry::FaceTriangulation;
using Site = FaceTriangulation::Site;

// Of the part's largest dimension, where no bound is asked for: the samples of flat faces, and the finest ones.
constexpr double kMost = 0.1;
constexpr double kLeast = 1e-3;
// On a sphere the centre of an equilateral triangle lies r^2 / (6 R) below, the middles of its sides only r^2 / (8 R).
constexpr double kCentre = 0.75;
constexpr geometry::RoundLimits kLimits{24, 8};

SpacingBounds bounds_of(const Options& options, double chord, double size, double shortest) {
    SpacingBounds bounds;
    bounds.chord = kCentre * chord;
    bounds.most = options.max_edge > 0.0 ? options.max_edge : kMost * size;
    // Where the spacing is no longer than the chord height, no curvature takes a triangle farther from the surface.
    const double least = chord > 0.0 ? chord : kLeast * size;
    bounds.least = std::min(bounds.most, std::max({options.min_edge, shortest, least}));
    return bounds;
}

std::vector<Site> along_curve(const std::vector<FaceSampler::Candidate>& samples, const geometry::FaceBorder& border) {
    Vec2 low = Vec2::Constant(1e300);
    Vec2 high = Vec2::Constant(-1e300);
    for (const FaceSampler::Candidate& s : samples) {
        low = low.cwiseMin(border.scaled(s.site.uv));
        high = high.cwiseMax(border.scaled(s.site.uv));
    }
    const double size = std::max((high - low).maxCoeff(), 1e-300);
    std::vector<std::pair<std::uint32_t, std::size_t>> order;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        order.emplace_back(along_z_curve((border.scaled(samples[i].site.uv) - low) / size), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<Site> sites;
    for (const auto& entry : order) {
        sites.push_back(samples[entry.second].site);
    }
    return sites;
}

class PartSampler {
  public:
    PartSampler(geometry::Session& session, const SingleGrid& grid, const Options& options, double chord,
                geometry::InitialTriangulation coarse, Progress& progress)
        : session_(session),
          grid_(grid),
          options_(options),
          progress_(progress),
          bounds_(bounds_of(options, chord, session.topology().box.largest_side(), grid.shortest_side())),
          coarse_(std::move(coarse)),
          result_{{coarse_.chains, {}, coarse_.failures}, {}, true} {
        add_face_spacings(session_, coarse_, grid_, bounds_, field_, progress_);
        EdgeSampler edges(session_, coarse_.chains, bounds_, field_);
        field_.build();
        edges.resample(result_.faces.chains);
    }

    SampledTriangulation run();

  private:
    void sample_face(int face, bool border_may_change);
    std::vector<FaceSampler::Candidate> samples_of(const SamplingContext& context, int face,
                                                   const geometry::FaceBorder& border);
    std::size_t room_for(int face) const;

    geometry::Session& session_;
    const SingleGrid& grid_;
    const Options& options_;
    Progress& progress_;
    SpacingBounds bounds_;
    SpacingField field_;
    geometry::InitialTriangulation coarse_;
    SampledTriangulation result_;
    std::map<int, std::string> fallbacks_;  // by face
    std::map<int, std::size_t> samples_;    // by face, how many
};

SampledTriangulation PartSampler::run() {
    geometry::InitialTriangulation& faces = result_.faces;
    faces.faces.resize(coarse_.faces.size());
    std::vector<int> open;
    for (int f = 0; f < static_cast<int>(coarse_.faces.size()); ++f) {
        if (!coarse_.faces[f].triangles.empty()) {
            open.push_back(f);
        } else {
            faces.faces[f].failure = coarse_.faces[f].failure;
        }
    }
    geometry::triangulate_in_rounds(
        session_, faces, std::move(open), kLimits, progress_,
        [&](int f) { return !coarse_.faces[f].triangles.empty(); },
        [&](int f, bool border_may_change) { sample_face(f, border_may_change); });
    result_.fallbacks.assign(fallbacks_.begin(), fallbacks_.end());
    return std::move(result_);
}

// Every sample brings two triangles.
std::size_t PartSampler::room_for(int face) const {
    std::size_t others = 0;
    for (const auto& [f, count] : samples_) {
        others += f != face ? count : 0;
    }
    return options_.budget() / 2 > others ? options_.budget() / 2 - others : 0;
}

std::vector<FaceSampler::Candidate> PartSampler::samples_of(const SamplingContext& context, int face,
                                                            const geometry::FaceBorder& border) {
    auto samples = options_.method == Method::Star ? sample_star(context, face, border)
                                                   : sample_sprinkle(context, face, border, options_.seed);
    samples_[face] = samples.size();
    result_.complete = result_.complete && samples.size() < context.most_samples;
    return samples;
}

void PartSampler::sample_face(int face, bool border_may_change) {
    FaceTriangulation& made = result_.faces.faces[face];
    made = {};
    fallbacks_.erase(face);
    const geometry::FaceBorder border = face_border(session_, result_.faces.chains, grid_, face, made.failure);
    if (!made.failure.empty()) {
        return;
    }
    const SamplingContext context{session_, grid_, bounds_, field_, progress_, room_for(face)};
    const std::vector<FaceSampler::Candidate> samples = samples_of(context, face, border);
    if (options_.connectivity == Connectivity::PseudoDelaunay) {
        made = triangulate_pseudo_delaunay(context, face, border, samples, coarse_.faces[face]);
        if (made.failure.empty()) {
            return;
        }
        fallbacks_[face] = made.failure;
    }
    made =
        triangulate_face(session_, result_.faces.chains, grid_, face, border_may_change, along_curve(samples, border));
}

}  // namespace

SampledTriangulation sample_part(geometry::Session& session, const SingleGrid& grid, const Options& options,
                                 double chord, geometry::InitialTriangulation coarse, Progress& progress) {
    return PartSampler(session, grid, options, chord, std::move(coarse), progress).run();
}

}  // namespace mq::triangulate

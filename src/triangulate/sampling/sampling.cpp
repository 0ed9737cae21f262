// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sampling/sampling.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "triangulate/initial/face_boundary.h"
#include "triangulate/initial/triangulation_rounds.h"
#include "triangulate/sampling/pseudo_delaunay.h"
#include "triangulate/sampling/sprinkle.h"
#include "triangulate/sampling/star.h"
#include "triangulate/sampling/tuning.h"
#include "triangulate/spacing/edge_sampler.h"
#include "triangulate/spacing/face_spacing.h"
#include "triangulate/spacing/morton_order.h"

namespace mq::triangulate {

namespace {
using VertexUse = FaceMesh::VertexUse;

// On a sphere the centre of an equilateral triangle lies r^2 / (6 R) below, the middles of its sides only r^2 / (8 R):
// the ratio of both.
constexpr double kCentre = 0.75;
// Limits of all rounds, and of those that shape the border: see RoundLimits.
constexpr RoundLimits kLimits{24, 8};

SpacingBounds bounds_of(const TriangulateOptions& options, double chord, double size, double shortest) {
    SpacingBounds bounds;
    bounds.chord = kCentre * chord;
    bounds.most = options.max_edge > 0.0 ? options.max_edge : SamplingTuning::kMostSpacing * size;
    // With a spacing as small as the chord tolerance, triangles keep the tolerance for any curvature.
    const double least = chord > 0.0 ? chord : SamplingTuning::kLeastSpacing * size;
    bounds.least = std::min(bounds.most, std::max({options.min_edge, shortest, least}));
    return bounds;
}

std::vector<VertexUse> along_curve(const std::vector<FaceSampler::Candidate>& samples, const FaceBoundary& border) {
    Vec2 low = Vec2::Constant(1e300);
    Vec2 high = Vec2::Constant(-1e300);
    for (const FaceSampler::Candidate& s : samples) {
        low = low.cwiseMin(border.scaled(s.site.uv));
        high = high.cwiseMax(border.scaled(s.site.uv));
    }
    const double size = std::max((high - low).maxCoeff(), 1e-300);
    std::vector<std::pair<std::uint32_t, std::size_t>> order;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        order.emplace_back(morton_order((border.scaled(samples[i].site.uv) - low) / size), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<VertexUse> sites;
    for (const auto& entry : order) {
        sites.push_back(samples[entry.second].site);
    }
    return sites;
}

std::size_t pieces_of_edges(const EdgeDiscretisation& chains, const geometry::Topology& topology) {
    std::size_t pieces = 0;
    for (const auto& use : topology.uses) {
        const EdgePolyline& chain = chains.chain(use.edge);
        pieces += chain.collapsed ? 0 : chain.t.size() - 1;
    }
    return pieces;
}

class PartSampler {
  public:
    PartSampler(geometry::Session& session, const SinglePrecisionGrid& grid, const TriangulateOptions& options,
                double chord, InitialTriangulation coarse, Progress& progress)
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
        on_edges_ = pieces_of_edges(result_.faces.chains, session_.topology());
    }

    SampledTriangulation run();

  private:
    void sample_face(int face, bool border_may_change);
    std::vector<FaceSampler::Candidate> samples_of(const SamplingContext& context, int face,
                                                   const FaceBoundary& border);
    std::size_t room_for(int face) const;
    std::size_t triangles() const;

    geometry::Session& session_;
    const SinglePrecisionGrid& grid_;
    const TriangulateOptions& options_;
    Progress& progress_;
    SpacingBounds bounds_;
    SpacingField field_;
    InitialTriangulation coarse_;
    SampledTriangulation result_;
    std::map<int, std::string> fallbacks_;  // by face: the reason
    std::map<int, std::size_t> samples_;    // by face: number of samples
    std::size_t all_samples_ = 0;           // number of samples of all faces
    std::size_t on_edges_ = 0;              // number of pieces of edges, each for every face that uses it
};

SampledTriangulation PartSampler::run() {
    InitialTriangulation& faces = result_.faces;
    if (static_cast<double>(on_edges_) > SamplingTuning::kMostOnEdges * static_cast<double>(options_.budget())) {
        return {std::move(coarse_), {}, false};
    }
    faces.faces.resize(coarse_.faces.size());
    std::vector<int> open;
    for (int f = 0; f < static_cast<int>(coarse_.faces.size()); ++f) {
        if (!coarse_.faces[f].triangles.empty()) {
            open.push_back(f);
        } else {
            faces.faces[f].failure = coarse_.faces[f].failure;
        }
    }
    triangulate_in_rounds(
        session_, faces, std::move(open), kLimits, progress_,
        [&](int f) { return !coarse_.faces[f].triangles.empty(); },
        [&](int f, bool border_may_change) { sample_face(f, border_may_change); });
    result_.fallbacks.assign(fallbacks_.begin(), fallbacks_.end());
    if (triangles() > options_.budget()) {  // pieces of edges were halved after faces beside them had been sampled
        return {std::move(coarse_), {}, false};
    }
    return std::move(result_);
}

std::size_t PartSampler::triangles() const {
    const std::vector<FaceMesh>& faces = result_.faces.faces;
    return std::accumulate(faces.begin(), faces.end(), std::size_t{0},
                           [](std::size_t sum, const FaceMesh& face) { return sum + face.triangles.size(); });
}

// Returns the number of samples the budget allows on a face: each adds two triangles, a piece of its border one.
std::size_t PartSampler::room_for(int face) const {
    const auto own = samples_.find(face);
    const std::size_t others = all_samples_ - (own != samples_.end() ? own->second : 0);
    const std::size_t used = on_edges_ + 2 * others;
    return options_.budget() > used ? (options_.budget() - used) / 2 : 0;
}

std::vector<FaceSampler::Candidate> PartSampler::samples_of(const SamplingContext& context, int face,
                                                            const FaceBoundary& border) {
    auto samples = options_.method == Method::Star ? sample_star(context, face, border)
                                                   : sample_sprinkle(context, face, border, options_.seed);
    std::size_t& own = samples_[face];
    all_samples_ += samples.size() - own;
    own = samples.size();
    result_.complete = result_.complete && samples.size() < context.most_samples;
    return samples;
}

void PartSampler::sample_face(int face, bool border_may_change) {
    FaceMesh& made = result_.faces.faces[face];
    made = {};
    fallbacks_.erase(face);
    const FaceBoundary border = face_boundary(session_, result_.faces.chains, grid_, face, made.failure);
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

SampledTriangulation sample_shape(geometry::Session& session, const SinglePrecisionGrid& grid,
                                  const TriangulateOptions& options, double chord, InitialTriangulation coarse,
                                  Progress& progress) {
    return PartSampler(session, grid, options, chord, std::move(coarse), progress).run();
}

}  // namespace mq::triangulate

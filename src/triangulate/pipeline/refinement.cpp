// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/pipeline/refinement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.h"
#include "triangulate/measure/deviation_peaks.h"
#include "triangulate/operators/border_normals.h"
#include "triangulate/optimise/cavity_optimiser.h"
#include "triangulate/optimise/vertex_removal.h"
#include "triangulate/refine/doubled_edges.h"
#include "triangulate/refine/encroaching_vertices.h"
#include "triangulate/refine/tuning.h"
#include "triangulate/virtual_topology/smooth_edge_removal.h"

namespace mq::triangulate {

namespace {

// Fractions of the whole work, for the progress.
constexpr double kCoarse = 0.15;
constexpr double kRefined = 0.8;

// Growth in the number of triangles after which they are ordered in space again: half of them then lie in the order of
// their creation.
constexpr double kGrown = 2.0;
// Number of triangles above which their order counts: fewer, at about 200 bytes each, fit into the caches of a
// processor.
constexpr int kInCaches = 8192;

// Whether vertices may be removed. The samples and the paper's mesh are kept as they are.
bool may_coarsen(const Workspace& work, const TriangulateOptions& options) {
    return options.method == Method::Refine && options.insertion != Insertion::Circumcentre && !work.over_budget();
}

Sizing sizing_of(const TriangulateOptions& options, double chord, const Workspace& work) {
    EdgeBounds bounds(work.session.topology(), options.max_edge, options.local_sizes);
    bounds.set_field(options.size_field, work.grid.origin());
    return {chord, std::move(bounds), options.edges_per_circle > 0.0 ? 2.0 * M_PI / options.edges_per_circle : 0.0,
            options.growth, 2.0 * options.min_angle * kDegree};
}

// Returns about how many triangles the distance alone asks for, by the slopes of the surfaces at the corners of an
// initial triangulation: heights grow with the square of lengths, as areas do.
std::size_t expected_triangles(const ClassifiedMesh& mesh, double chord) {
    double sum = 0.0;
    for (int t = 0; chord > 0.0 && t < mesh.triangle_count(); ++t) {
        const auto corner = [&](int k) { return mesh.site(mesh.site_of(3 * t + k)); };
        sum += std::max(1.0, expected_peak(corner(0), corner(1), corner(2)).height / chord);
    }
    return static_cast<std::size_t>(sum);
}

}  // namespace

double share_before_refinement(const TriangulateOptions& options) {
    return options.method == Method::Refine ? kCoarse : options.keeps_bounds() ? 0.5 : 0.9;
}

Refinement::Refinement(Workspace& work, MeasurementCache& findings, const TriangulateOptions& options, double chord,
                       int first_vertex, EndStage end_stage)
    : work_(work),
      findings_(findings),
      options_(options),
      chord_(chord),
      first_vertex_(first_vertex),
      end_stage_(std::move(end_stage)),
      sizing_(sizing_of(options, chord, work)),
      segments_(work, options.insertion != Insertion::Circumcentre, options.min_angle * kDegree),
      angles_(work, segments_, options.min_angle, options.insertion, chord,
              options.order == Order::WorstFirst ? 1 : options.sites_in_round),
      chords_(work, segments_, findings.chords, sizing_),
      crossings_(work, segments_, findings.crossings, findings.bodies),
      vertices_before_(work.mesh.vertex_count()),
      sites_before_(work.mesh.site_count()),
      ordered_(work.mesh.triangle_count()) {}

void Refinement::prepare() {
    remove_encroaching_vertices(work_);
    use_interior_normals(work_);
    separate_doubled_segments(work_, segments_, touched_);
}

void Refinement::run() {
    const double before = share_before_refinement(options_);
    const double middle = before + 0.34 * (0.9 - before);
    work_.progress.stage("refining angles", before, sizing_.any() ? middle : kRefined);
    refine_angles();
    end_stage_("angles");
    work_.progress.stage("refining to the chord height", middle, kRefined);
    refine_chords();
    separate_doubled();
    end_stage_("chord height");
    if (first_vertex_ < work_.mesh.vertex_count() && may_coarsen(work_, options_)) {
        work_.progress.stage("taking out vertices", kRefined, 0.82);
        order_in_space();
        VertexRemoval(work_, findings_.chords, options_.min_angle, sizing_, first_vertex_).run();
        order_in_space();  // vertices that are gone take memory
        refine_chords();   // vertex removal measures fewer places
        end_stage_("taking out vertices");
    }
    if (work_.over_budget()) {
        return;  // the limit ends the work: later steps would improve a mesh that is not complete
    }
    work_.progress.stage("separating crossings", 0.82, 0.85);
    separate_crossings();
    end_stage_("crossings");
    if (options_.insertion != Insertion::Circumcentre) {
        work_.progress.stage("mending", 0.85, 0.9);
        mend(work_, options_.min_angle, sizing_);
        end_stage_("mending");
        separate_crossings();  // crossings of triangles that were changed for better angles
        end_stage_("crossings");
    }
}

Message Refinement::release_smooth_edges() {
    if (options_.keep_edges != KeepEdges::Feature || work_.over_budget()) {
        return {};
    }
    work_.progress.stage("releasing smooth edges", 0.88, 0.9);
    Message released = remove_smooth_edges(work_, options_, sizing_);
    end_stage_("smooth edges");
    return released;
}

// The first run of Algorithm M.
void Refinement::refine_angles() {
    if (options_.record_angles) {
        work_.angle_history.start();
    }
    work_.angle_history.record(work_);
    const std::size_t budget = work_.budget;
    if (options_.costly_above > 0) {
        constexpr std::size_t kMostTimes = 20;
        const std::size_t many = std::max(kMostTimes * work_.triangles(), 2 * expected_triangles(work_.mesh, chord_));
        work_.budget = std::min(budget, std::max(options_.costly_above, many));
    }
    angles_.run();
    if (!work_.over_budget()) {
        work_.budget = budget;
    }
    work_.angle_history.record(work_);  // triangles may have been exempted since the last vertex
    work_.angle_history.stop();
}

void Refinement::refine_chords() {
    for (int round = 0;
         sizing_.any() && round < RefinementTuning::kMaxChordRounds && chords_.run([&] { order_where_grown(); });
         ++round) {
        angles_.run();
        work_.progress.advance((round + 1.0) / RefinementTuning::kMaxChordRounds);
    }
}

void Refinement::order_where_grown() {
    if (work_.mesh.triangle_count() > kGrown * ordered_) {
        order_in_space();
    }
}

void Refinement::order_in_space() {
    ordered_ = work_.mesh.triangle_count();
    if (ordered_ < kInCaches) {
        return;
    }
    const NewIndices renewed = work_.mesh.order_in_space(vertices_before_, sites_before_);
    work_.maxmin.rebuild();
    work_.settled.renumber(renewed);
    move_to_indices(renewed.vertices, work_.shrinks, 0);
    move_to_indices(renewed.triangles, work_.exempt);
    for (auto& [triangle, exemption] : work_.exempt) {
        exemption.vertex = exemption.vertex < 0 ? -1 : renewed.vertices[static_cast<std::size_t>(exemption.vertex)];
    }
    findings_.chords.renumber(renewed);
    angles_.renumber(renewed);
    chords_.renumber(renewed);
}

void Refinement::refine_again() {
    angles_.run();
    refine_chords();
}

// Splitting a segment between triangles with the same third corner on two faces doubles the edge to that corner.
void Refinement::separate_doubled() {
    for (int n = 0; n < RefinementTuning::kMaxDoubledRounds && separate_doubled_edges(work_, touched_); ++n) {
        refine_again();
    }
}

// Splits crossing triangles, however short the new edges are: a mesh that does not cross itself takes precedence over
// min_edge.
// @return whether anything was split
bool Refinement::split_crossings() {
    const double asked = std::exchange(work_.min_edge, 0.0);
    const bool any = crossings_.run();
    work_.min_edge = asked;
    return any;
}

bool Refinement::split_crossings_of_bodies() {
    const double asked = std::exchange(work_.min_edge, 0.0);
    const bool any = crossings_.run_between_bodies(chord_);
    work_.min_edge = asked;
    return any;
}

void Refinement::separate_bodies() {
    if (!(chord_ > 0.0) || work_.over_budget() || findings_.crossings.pairs_of_bodies().empty()) {
        return;
    }
    work_.progress.stage("separating crossings", 0.87, 0.88);
    const double most = RefinementTuning::kMostForBodies * static_cast<double>(work_.triangles());
    bool any = false;
    for (int round = 0; round < RefinementTuning::kMaxBodyRounds && static_cast<double>(work_.triangles()) < most &&
                        split_crossings_of_bodies();
         ++round) {
        refine_again();
        any = true;
    }
    if (any) {
        separate_crossings();
    }
    end_stage_("crossings of bodies");
}

void Refinement::separate_crossings() {
    for (int round = 0; round < RefinementTuning::kMaxCrossingRounds && split_crossings(); ++round) {
        refine_again();
    }
    separate_doubled();
}

}  // namespace mq::triangulate

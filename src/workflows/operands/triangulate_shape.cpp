// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/operands/triangulate_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "base/message.h"
#include "base/single_precision_grid.h"
#include "base/stopwatch.h"
#include "base/threads/schedule_hooks.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/distance/shape_distance.h"
#include "geometry/occt/shape_model.h"
#include "geometry/occt/solid_volume.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/quality/deviation_samples.h"
#include "triangulate/triangulate.h"

namespace mq::workflows {

namespace {

using triangulate::Result;

/// Adds a note for thin models, which lose volume to the single-precision numbers of a mesh in FreeCAD, whatever the
/// options are.
void note_lost_volume(Result& result, const TopoDS_Shape& shape, geometry::Engine& engine, const Progress& progress) {
    constexpr double kThin = 2e-3;  // fraction of the volume by which the rounding of all vertices can change it
    constexpr double kLost = 1e-2;  // fraction of the volume
    const mesh::MeshReport& report = result.report;
    if (!report.closed || report.box.empty()) {
        return;
    }
    const double resolution = SinglePrecisionGrid(report.box).resolution();
    if (report.area * resolution < kThin * std::abs(report.volume)) {
        return;
    }
    double content = 0.0;
    engine.run([&] { content = geometry::solid_content(shape, &progress).volume; }, &progress);
    const double lost = content - report.volume;
    if (content > 0.0 && std::abs(lost) > kLost * content) {
        result.report.notes.push_back({phrases::kThinPart,
                                       {{"volume", in_digits(content, 4) + " mm³"},
                                        {"volume2", in_digits(report.volume, 4) + " mm³"},
                                        {"length", in_mm(resolution, 2)}}});
    }
}

double shortest_side(const mesh::TriangleMesh& mesh, std::int32_t triangle) {
    const auto& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 side = mesh.vertices[static_cast<std::size_t>(corners[i])] -
                          mesh.vertices[static_cast<std::size_t>(corners[(i + 1) % 3])];
        least = std::min(least, side.norm());
    }
    return least;
}

/// The number of triangles below the bound that are not each the one triangle of a narrow corner, or of an apex, of the
/// shape itself, and that are there at all because of the bound on angles. Sides of a corner that are closer together
/// than the detail where its triangle ends are not told apart: it explains nothing.
std::ptrdiff_t unexplained(const Result& result) {
    using mesh::ExemptCause;
    const std::array<ExemptCause, 4> explained{ExemptCause::NarrowCorner, ExemptCause::Apex, ExemptCause::Budget,
                                               ExemptCause::MinEdge};
    return std::count_if(result.report.exempt.begin(), result.report.exempt.end(), [&](const auto& item) {
        return std::find(explained.begin(), explained.end(), item.second.cause) == explained.end() ||
               (item.second.cause == ExemptCause::NarrowCorner &&
                shortest_side(result.mesh, item.first) < result.report.detail);
    });
}

/// The number of entities of a shape that count as one with another one, and of its narrow corners that are cut off.
std::size_t identified(const geometry::Topology& topology) {
    return topology.joined.size() + topology.cut_corners.size();
}

struct Attempt {
    Result result;
    std::size_t identified = 0;
};

/// @param before  what the attempts before this one have identified
/// @return none where nothing else can be
std::optional<Attempt> attempt(geometry::Engine& engine, const TopoDS_Shape& shape,
                               const triangulate::TriangulateOptions& options, geometry::CornerCuts cuts,
                               std::optional<std::size_t> before, Progress& progress, triangulate::MeshCache* cache) {
    const Stopwatch watch;
    std::shared_ptr<geometry::Model> model;
    progress.stage("reading the shape", 0.0, 0.0);
    const geometry::VirtualTopology join{[&](const Box& box) { return options.detail_of(box); }, options.sew,
                                         options.imprint, cuts};
    engine.run(
        [&] { model = geometry::make_shape_model(shape, &progress, geometry::Creases::Cut, join, options.evaluation); },
        &progress);
    if (before == identified(model->topology())) {
        return std::nullopt;
    }
    const double reading = watch.wall();
    ScheduleTrace::name_work("read the shape");
    Result result = triangulate::triangulate(engine, model, options, &progress, cache);
    result.report.seconds.insert(result.report.seconds.begin(), {"read the shape", reading});
    return Attempt{std::move(result), identified(model->topology())};
}

bool asks_for_sizes(const triangulate::TriangulateOptions& options) {
    return options.max_edge > 0.0 || !options.local_sizes.empty() || options.size_field != nullptr ||
           options.edges_per_circle > 0.0 || options.growth > 0.0;
}

/// Whether a number of triangles is many times that which the distance alone asks for, as a report has it.
bool is_costly(std::size_t triangles, const mesh::MeshReport& report) {
    constexpr std::size_t kMostTimes = 20;
    return report.chord_triangles > 0 && triangles > kMostTimes * report.chord_triangles;
}

/// Whether an attempt may be followed by one with larger details, so that it need not be done in full.
bool may_stop(const triangulate::TriangulateOptions& options) {
    return !asks_for_sizes(options) && options.max_triangles == 0 && !options.record_angles &&
           options.method == triangulate::Method::Refine &&
           (options.chord_height > 0.0 || options.chord_height_relative > 0.0);
}

/// The same options, but an attempt that need not be done in full ends as soon as details cost more than `triangles`.
triangulate::TriangulateOptions stopped_where_costly(triangulate::TriangulateOptions options, std::size_t triangles) {
    options.costly_above = may_stop(options) ? triangles : 0;
    return options;
}

/// Whether a mesh keeps no less than another one.
bool keeps_as_much(const mesh::MeshReport& report, const mesh::MeshReport& other) {
    const auto too_far = [](const mesh::MeshReport& one) {
        return one.chord_height_asked > 0.0 ? std::max(0.0, one.max_chord_height - one.chord_height_asked) : 0.0;
    };
    return report.self_intersections <= other.self_intersections && too_far(report) <= too_far(other) &&
           report.complete && report.closed == other.closed && report.manifold >= other.manifold;
}

/// Whether a mesh has no crossings and keeps the distance: of a stopped one nobody knows.
bool is_sound(const mesh::MeshReport& report) {
    return report.complete && report.self_intersections == 0 && report.max_chord_height <= report.chord_height_asked;
}

/// Attempts to mesh a shape, of which the best is kept.
class Attempts {
  public:
    Attempts(geometry::Engine& engine, const TopoDS_Shape& shape, const triangulate::TriangulateOptions& options,
             Progress& progress, triangulate::MeshCache* cache)
        : engine_(engine), shape_(shape), options_(options), progress_(progress), best_(first(cache)) {}

    /// Larger details, up to half of the distance, where keeping smaller ones takes more than twenty times the
    /// triangles that the distance asks for. Where that was stopped, and larger details do not help, it is done in
    /// full.
    void raise_detail() {
        const std::size_t at_first = best_.result.mesh.triangles.size();
        for (const double share : {0.2, 0.5}) {
            const std::size_t triangles = best_.result.mesh.triangles.size();
            const bool stopped = !best_.result.report.complete;
            if (stopped ? !may_stop(options_)
                        : asks_for_sizes(options_) || !is_costly(triangles, best_.result.report)) {
                return;
            }
            // About half of the triangles go again with the vertices that are taken out.
            triangulate::TriangulateOptions coarser = stopped_where_costly(options_, 2 * triangles);
            coarser.detail = share * best_.result.report.chord_height_asked;
            const auto cuts =
                coarser.corners == triangulate::Corners::Auto ? geometry::CornerCuts::All : coarser.corner_cuts();
            // Where something is identified, the same with another detail is identified elsewhere.
            const auto before = best_.identified == 0 ? std::optional<std::size_t>(0) : std::nullopt;
            if (try_with(coarser, cuts, before, [&](const Result& other) {
                    return unexplained(other) <= unexplained(best_.result) &&
                           (stopped ? is_costly(triangles, other.report) && is_sound(other.report)
                                    : other.mesh.triangles.size() < triangles &&
                                          keeps_as_much(other.report, best_.result.report));
                })) {
                options_.detail = coarser.detail;
                larger_details_ = {phrases::kLargerDetails, {{"length", in_mm(coarser.detail)}, {"count", at_first}}};
            }
        }
    }

    /// Without a stop, where all attempts before were stopped.
    void complete() {
        if (!best_.result.report.complete && may_stop(options_)) {
            const double before = watch_.wall();
            replace_best(*attempt(engine_, shape_, options_, cuts_, std::nullopt, progress_, nullptr), before);
        }
    }

    /// Other narrow corners that are cut off, where triangles are left below the bound that are none.
    void cut_other_corners() {
        for (const geometry::CornerCuts cuts : {geometry::CornerCuts::All, geometry::CornerCuts::None}) {
            if (options_.corners != triangulate::Corners::Auto || !options_.keeps_bounds() ||
                !best_.result.report.complete || unexplained(best_.result) == 0) {
                return;
            }
            try_with(options_, cuts, best_.identified, [&](const Result& other) {
                return unexplained(other) < unexplained(best_.result) &&
                       other.report.self_intersections <= best_.result.report.self_intersections;
            });
        }
    }

    Result take() {
        if (!larger_details_.empty()) {
            best_.result.report.notes.insert(best_.result.report.notes.begin(), larger_details_);
        }
        best_.result.report.cpu_seconds = watch_.cpu();
        return std::move(best_.result);
    }

  private:
    /// @return the first attempt that the topology of the shape does not refuse
    /// @throws TopologyError of the first one, if all are refused
    Attempt first(triangulate::MeshCache* cache) {
        const geometry::CornerCuts by_options = options_.corner_cuts();
        constexpr std::size_t kFewTriangles = 100'000;  // take a second or two
        const triangulate::TriangulateOptions stopped = stopped_where_costly(options_, kFewTriangles);
        cuts_ = by_options;
        try {
            return *attempt(engine_, shape_, stopped, by_options, std::nullopt, progress_, cache);
        } catch (const TopologyError&) {
            for (const geometry::CornerCuts cuts : {geometry::CornerCuts::All, geometry::CornerCuts::None}) {
                const bool other = by_options == geometry::CornerCuts::Infeasible;
                if (auto found = other ? unless_refused(stopped, cuts, std::nullopt) : std::nullopt) {
                    cuts_ = cuts;
                    return std::move(*found);
                }
            }
            throw;
        }
    }

    /// @return none where the topology refuses the attempt, or nothing else can be identified in it
    std::optional<Attempt> unless_refused(const triangulate::TriangulateOptions& options, geometry::CornerCuts cuts,
                                          std::optional<std::size_t> before) {
        try {
            return attempt(engine_, shape_, options, cuts, before, progress_, nullptr);
        } catch (const TopologyError&) {
            return std::nullopt;
        }
    }

    /// @return whether the other attempt took the place of the best
    template <typename Better>
    bool try_with(const triangulate::TriangulateOptions& options, geometry::CornerCuts cuts,
                  std::optional<std::size_t> identified_before, const Better& better) {
        const double before = watch_.wall();
        auto other = unless_refused(options, cuts, identified_before);
        if (!other || !better(other->result)) {
            return false;
        }
        replace_best(std::move(*other), before);
        return true;
    }

    /// @param before  s of the attempts before, on the clock
    void replace_best(Attempt other, double before) {
        best_ = std::move(other);
        best_.result.report.seconds.insert(best_.result.report.seconds.begin(), {"attempts before", before});
    }

    const Stopwatch watch_;
    geometry::Engine& engine_;
    const TopoDS_Shape& shape_;
    triangulate::TriangulateOptions options_;
    Progress& progress_;
    geometry::CornerCuts cuts_ = geometry::CornerCuts::None;  // the first attempt had them
    Attempt best_;
    Message larger_details_;  // what is said of them; empty: there are none
};

}  // namespace

Result triangulate_shape(geometry::Engine& engine, const TopoDS_Shape& shape,
                         const triangulate::TriangulateOptions& options, Progress& progress,
                         triangulate::MeshCache* cache) {
    options.validate();
    Attempts attempts(engine, shape, options, progress, cache);
    attempts.raise_detail();
    attempts.complete();
    attempts.cut_other_corners();
    Result result = attempts.take();
    note_lost_volume(result, shape, engine, progress);
    return result;
}

mesh::MeshReport report_with_crossings(const Result& surface, Progress& progress) {
    mesh::MeshReport report = surface.report;
    if (report.self_intersections < 0) {
        progress.stage("checking crossings", 0.0, 0.1);
        report.self_intersections = static_cast<std::int64_t>(
            mesh::self_intersections(surface.mesh.vertices, surface.mesh.triangles, mesh::kMostCounted, &progress)
                .size());
    }
    return report;
}

mesh::MeshReport measure_against_shape(const Result& surface, const TopoDS_Shape& shape, Progress& progress) {
    mesh::MeshReport report = report_with_crossings(surface, progress);
    progress.stage("measuring the distance", 0.1, 1.0);
    const mesh::DeviationSamples samples = mesh::deviation_samples(surface.mesh);
    const std::vector<double> distances = geometry::distances_to_faces(shape, samples.points, &progress);
    if (!distances.empty()) {
        const std::vector<double> of_triangles = samples.largest(distances);
        const auto worst = std::max_element(distances.begin(), distances.end());
        const auto triangle = std::max_element(of_triangles.begin(), of_triangles.end());
        report.max_chord_height = *worst;
        report.to_nearest_face = true;
        report.max_chord_point = samples.points[static_cast<std::size_t>(worst - distances.begin())];
        report.max_chord_triangle = static_cast<std::int32_t>(triangle - of_triangles.begin());
    }
    return report;
}

std::vector<double> triangle_deviations(const mesh::TriangleMesh& mesh, const TopoDS_Shape& shape, Progress& progress) {
    progress.stage("measuring the distance", 0.0, 1.0);
    const mesh::DeviationSamples samples = mesh::deviation_samples(mesh);
    return samples.largest(geometry::distances_to_faces(shape, samples.points, &progress));
}

}  // namespace mq::workflows

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/operands/triangulate_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

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

/// The number of triangles below the bound that are not each the one triangle of a narrow corner, or of an apex, of the
/// shape itself, and that are there at all because of the bound on angles.
std::ptrdiff_t unexplained(const Result& result) {
    using mesh::ExemptCause;
    const std::array<ExemptCause, 4> explained{ExemptCause::NarrowCorner, ExemptCause::Apex, ExemptCause::Budget,
                                               ExemptCause::MinEdge};
    return std::count_if(result.report.exempt.begin(), result.report.exempt.end(), [&](const auto& item) {
        return std::find(explained.begin(), explained.end(), item.second.cause) == explained.end();
    });
}

/// @param before  narrow corners that an attempt before this one has cut off
/// @return none where no others can be cut off
std::optional<Result> attempt(geometry::Engine& engine, const TopoDS_Shape& shape,
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
    if (before && model->topology().cut_corners.size() == *before) {
        return std::nullopt;
    }
    const double reading = watch.wall();
    ScheduleTrace::name_work("read the shape");
    Result result = triangulate::triangulate(engine, model, options, &progress, cache);
    result.report.seconds.insert(result.report.seconds.begin(), {"read the shape", reading});
    return result;
}

}  // namespace

Result triangulate_shape(geometry::Engine& engine, const TopoDS_Shape& shape,
                         const triangulate::TriangulateOptions& options, Progress& progress,
                         triangulate::MeshCache* cache) {
    options.validate();
    const Stopwatch watch_all;
    Result result = *attempt(engine, shape, options, options.corner_cuts(), std::nullopt, progress, cache);
    for (const geometry::CornerCuts cuts : {geometry::CornerCuts::All, geometry::CornerCuts::None}) {
        if (options.corners != triangulate::Corners::Auto || !options.keeps_bounds() || !result.report.complete ||
            unexplained(result) == 0) {
            break;
        }
        const double before = watch_all.wall();
        std::optional<Result> other =
            attempt(engine, shape, options, cuts, result.report.cut_corners, progress, nullptr);
        if (other && unexplained(*other) < unexplained(result) &&
            other->report.self_intersections <= result.report.self_intersections) {
            result = std::move(*other);
            result.report.seconds.insert(result.report.seconds.begin(), {"with other corners", before});
        }
    }
    note_lost_volume(result, shape, engine, progress);
    result.report.cpu_seconds = watch_all.cpu();
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/curve.h"

#include <algorithm>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/stopwatch.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/measuring.h"
#include "curve/surface/repair.h"
#include "curve/surface/self_intersections.h"
#include "curve/volume/remeshing/tetrahedralise_and_repair.h"
#include "curve/volume/straighten.h"
#include "option_ranges.h"

namespace mq::curve {

namespace {

/// Refuses a volume mesh of a shape without solids before any work is done.
void require_solids(const geometry::Topology& topology, const CurveOptions& options) {
    const auto solid = [](const geometry::Volume& volume) { return volume.kind == geometry::Volume::Kind::Solid; };
    if (options.volume && std::none_of(topology.volumes.begin(), topology.volumes.end(), solid)) {
        throw InvalidInput(phrases::kNoSolids);
    }
}

void repair(SurfaceEditor& editor, const geometry::Topology& topology, const CurveOptions& options, Progress& progress,
            CurveReport& report) {
    if (!options.repair) {
        return;
    }
    add_counts(repair_surface(editor, progress), report);
    if (options.volume) {
        const int halved = refine_crossings(editor, topology, progress);
        report.repairs.emplace_back("surface edges split where faces cross", static_cast<std::size_t>(halved));
    }
}

/// Joins stages of one name: solids may be filled and repaired more than once.
StageTimes joined(const StageTimes& stages) {
    StageTimes result;
    for (const auto& [name, seconds] : stages) {
        const auto known =
            std::find_if(result.begin(), result.end(), [&](const auto& stage) { return stage.first == name; });
        if (known == result.end()) {
            result.emplace_back(name, seconds);
        } else {
            known->second += seconds;
        }
    }
    return result;
}

}  // namespace

void CurveOptions::validate() const {
    const int most = volume ? elements::kMaxOrder - 1 : elements::kMaxOrder;
    if (order < 1 || order > most) {
        throw InvalidInput(volume ? phrases::kVolumeOrder : phrases::kSurfaceOrder,
                           {{"count", order}, {"count2", most}});
    }
    ranges::triangulate::kThreads.require(threads);
    if (volume && !repair) {
        throw InvalidInput(phrases::kVolumeNeedsRepair);
    }
}

CurvedMesh curve(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                 const mesh::TriangleMesh& straight, const CurveOptions& options, Progress* progress) {
    options.validate();
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    CurveReport report;
    StageTimer clock(report.seconds);
    const double start = cpu_seconds();

    geometry::Session session(engine, model, &watched);
    require_solids(session.topology(), options);
    watched.stage("classifying", 0.0, 0.1);
    CurvedSurface surface = classify(session, straight, options.order);
    clock.end("classifying");
    watched.stage("curving the surface", 0.1, 0.3);
    SurfaceEditor editor(session, surface);
    editor.placement.place(live_triangles(surface));
    clock.end("curving the surface");
    watched.stage("repairing the surface", 0.3, 0.5);
    repair(editor, session.topology(), options, watched, report);
    const std::set<int> straight_triangles = options.straighten ? straighten_triangles(editor) : std::set<int>();
    clock.end("repairing the surface");
    std::optional<RepairedTetrahedralMesh> filled;
    if (options.volume) {
        filled.emplace(tetrahedralise_and_repair(session, surface, watched, clock, options.size_field.get()));
        add_counts(filled->repairs, report);
    }
    CurvedMesh result = measured_mesh(editor, straight_triangles, filled ? &filled->volume : nullptr,
                                      session.topology(), options.straighten, report, watched);
    clock.end("measuring");
    report.seconds = joined(report.seconds);
    report.cpu_seconds = cpu_seconds() - start;
    result.report = std::move(report);
    return result;
}

}  // namespace mq::curve

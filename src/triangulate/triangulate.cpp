// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/triangulate.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/predicates.h"
#include "base/stopwatch.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/quality/exemptions.h"
#include "triangulate/incremental/cache_restore.h"
#include "triangulate/incremental/cache_store.h"
#include "triangulate/pipeline/assemble.h"
#include "triangulate/pipeline/component_refinement.h"
#include "triangulate/pipeline/refinement.h"
#include "triangulate/refine/doubled_edges.h"
#include "triangulate/refine/tuning.h"
#include "triangulate/report/chord_triangles.h"
#include "triangulate/report/costly_slivers.h"
#include "triangulate/report/final_report.h"
#include "triangulate/report/joined_corners.h"
#include "triangulate/report/manifold_output.h"
#include "triangulate/report/stage_meshes.h"
#include "triangulate/sampling/sampling.h"

namespace mq::triangulate {

namespace {

void check_against_shape(const TriangulateOptions& options, const geometry::Topology& topology,
                         const SinglePrecisionGrid& grid) {
    const auto something = [](const geometry::Face& face) { return !face.no_area; };
    if (std::none_of(topology.faces.begin(), topology.faces.end(), something)) {
        throw InvalidInput(phrases::kNoFaces);
    }
    const double chord = options.chord_height_of(topology.box);
    if (chord > 0.0 && chord < 4.0 * grid.resolution()) {
        throw InvalidInput(phrases::kFineChordHeight,
                           {{"length", in_mm(chord)}, {"length2", in_mm(4.0 * grid.resolution())}});
    }
    const auto require_edges = [&](Phrase phrase, const char* place, const std::string& name, double length) {
        if (length > 0.0 && length < grid.shortest_side()) {
            throw InvalidInput(phrase,
                               {{place, name}, {"length", in_mm(length)}, {"length2", in_mm(grid.shortest_side())}});
        }
    };
    require_edges(phrases::kShortEdges, "option", "max_edge", options.max_edge);
    for (const LocalSize& size : options.local_sizes) {
        require_edges(phrases::kShortLocalSize, "name", geometry::name_of({size.dimension, size.index}), size.max_edge);
    }
    if (options.size_field != nullptr) {
        require_edges(phrases::kShortEdges, "option", "size_field", options.size_field->least_in(topology.box));
    }
}

std::string failed_faces(const InitialTriangulation& initial, const geometry::Topology& topology) {
    std::string text;
    for (const auto& [face, why] : initial.failures) {
        text += (text.empty() ? "" : "; ") + topology.name_of({2, face}) + ": " + why;
    }
    return text;
}

// Triangulates the faces over shared edges: coarsely, or over samples.
SampledTriangulation initial_or_sampled(geometry::Session& session, const SinglePrecisionGrid& grid,
                                        const TriangulateOptions& options, double chord, CacheRestore* restore,
                                        Progress& progress, StageTimer& clock) {
    const bool sampled = options.method != Method::Refine;
    progress.stage("initial triangulation", 0.0, sampled ? 0.05 : share_before_refinement(options));
    InitialTriangulation coarse = restore != nullptr ? triangulate_the_rest(session, grid, restore->begin(), progress)
                                                     : triangulate_initially(session, grid, progress);
    clock.end("initial triangulation");
    if (!sampled) {
        return {std::move(coarse), {}, true};
    }
    progress.stage("sampling", 0.05, share_before_refinement(options));
    SampledTriangulation samples = sample_shape(session, grid, options, chord, std::move(coarse), progress);
    clock.end("sampling");
    return samples;
}

void add_note(mesh::MeshReport& report, const Message& note) {
    if (!note.empty()) {
        report.notes.push_back(note);
    }
}

void check_failures(const InitialTriangulation& faces, const geometry::Topology& topology,
                    const TriangulateOptions& options) {
    if (!faces.failures.empty() && (!options.allow_missing_faces || faces.failures.size() == faces.faces.size())) {
        throw TopologyError(phrases::kNotTriangulated, {{"value", failed_faces(faces, topology)}});
    }
}

// Whether faces can be cached: samples are drawn anew, and triangles over removed smooth edges belong to no single
// face.
bool is_cacheable(const TriangulateOptions& options) {
    return options.method == Method::Refine && options.keep_edges == KeepEdges::All;
}

// Names edges of the shape, or pieces of them, that are vertices of the mesh.
Message contracted_edges(const std::vector<int>& edges, const geometry::Topology& topology) {
    std::vector<std::string> names;
    for (const int e : edges) {
        names.push_back(topology.name_of({1, e}));
    }
    return {phrases::kContracted, {{"list", mesh::list_of(names)}, {"length", in_mm(topology.detail)}}};
}

// Reports failures and fallbacks of the triangulation before refinement.
void report_first(const SampledTriangulation& first, const geometry::Topology& topology,
                  const TriangulateOptions& options, mesh::MeshReport& report) {
    for (const auto& failure : first.faces.failures) {
        report.missing.emplace_back(topology.of_shape({2, failure.first}).index, failure.second);
        report.notes.push_back(
            {phrases::kFaceMissing, {{"name", topology.name_of({2, failure.first})}, {"text", failure.second}}});
    }
    for (int face = 0; face < static_cast<int>(topology.faces.size()); ++face) {
        if (first.faces.chains.is_a_point(face)) {
            report.notes.push_back({phrases::kFaceIsPoint, {{"name", topology.name_of({2, face})}}});
        }
    }
    if (!first.faces.chains.contracted().empty()) {
        report.notes.push_back(contracted_edges(first.faces.chains.contracted(), topology));
    }
    for (const auto& [face, why] : first.fallbacks) {
        report.fallback.emplace_back(topology.of_shape({2, face}).index, why);
    }
    if (!first.complete && report.complete) {
        report.complete = false;
        report.notes.push_back({phrases::kSamplingEnded, {{"count", options.budget()}}});
    }
}

// Counts the faces of the shape of which any piece is present.
std::size_t count(const std::vector<std::shared_ptr<const CachedFace>>& faces, const geometry::Topology& topology) {
    std::set<int> found;
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
        if (faces[f] != nullptr) {
            found.insert(topology.of_shape({2, f}).index);
        }
    }
    return found.size();
}

/// Measures the costs of a run, from its construction on.
class Costs {
  public:
    explicit Costs(const geometry::Session& session) : session_(session), cpu_before_(cpu_seconds()) {
        predicate_count() = {};
    }

    StageTimer& clock() { return clock_; }

    void report(mesh::MeshReport& report) {
        report.seconds = std::move(seconds_);
        report.cpu_seconds = cpu_seconds() - cpu_before_;
        report.queries = session_.queries();
        report.predicates = predicate_count().filtered + predicate_count().exact;
        report.exact_predicates = predicate_count().exact;
    }

  private:
    const geometry::Session& session_;
    StageTimes seconds_;
    StageTimer clock_{seconds_};
    double cpu_before_;
};

/// One call of triangulate.
struct Task {
    geometry::Session& session;
    const SinglePrecisionGrid& grid;
    const TriangulateOptions& options;
    double chord;  // chord tolerance, mm; 0: none
    Progress& progress;
    Costs& costs;
};

// Returns the cached result of an earlier run with the same input.
Result reuse_result(Result result, Costs& costs) {
    const std::vector<std::int32_t>& faces = result.mesh.triangle_face;
    result.report.reused_faces = std::set<std::int32_t>(faces.begin(), faces.end()).size();
    costs.clock().end("handing out what is known");
    costs.report(result.report);
    return result;
}

Workspace workspace_of(const Task& task, const EdgeDiscretisation& chains, ClassifiedMesh& surface,
                       MaxMinSwaps& maxmin) {
    Workspace work{task.session, task.grid, surface, maxmin, task.progress};
    for (int e = 0; e < static_cast<int>(task.session.topology().edges.size()); ++e) {
        work.unresolved.push_back({chains.unresolved(e, 0), chains.unresolved(e, 1)});
    }
    work.floor = task.grid.shortest_side();
    work.min_edge = task.options.min_edge;
    work.unseen = RefinementTuning::kSmallestDetail * task.session.topology().box.largest_side();
    if (task.chord > 0.0) {
        work.unseen = std::min(work.unseen, task.chord);
    }
    return work;
}

// @return what was done about smooth edges, for the report
Message refine(Workspace& work, MeasurementCache& findings, const TriangulateOptions& options, double chord,
               StageMeshes& clock) {
    Refinement refinement(work, findings, options, chord, work.mesh.vertex_count(),
                          [&](const char* stage) { clock.end(stage); });
    refinement.prepare();
    StageTimes together;
    if (refine_components(refinement, findings.chords, together)) {
        clock.end_together(together);
    } else {
        refinement.run();
    }
    Refinement together_again(work, findings, options, chord, work.mesh.vertex_count(),
                              [&](const char* stage) { clock.end(stage); });
    together_again.separate_bodies();
    return together_again.release_smooth_edges();
}

// @param recall  the cached run to start with; null: none
// @param left  receives the data to be cached; null: nothing is cached
Result mesh_shape(const Task& task, const std::vector<geometry::Fingerprint>& keys, CacheRestore* restore,
                  CachedRun* left) {
    const TriangulateOptions& options = task.options;
    const geometry::Topology& topology = task.session.topology();
    StageTimer& clock = task.costs.clock();
    SampledTriangulation first =
        initial_or_sampled(task.session, task.grid, options, task.chord, restore, task.progress, clock);
    if (restore != nullptr && !first.faces.failures.empty()) {
        return mesh_shape(task, keys, nullptr, left);
    }
    check_failures(first.faces, topology, options);
    ClassifiedMesh surface = assemble(first.faces, topology);
    first.faces.faces = {};  // samples may be many
    StageMeshes stages(surface, topology, task.grid.origin(), clock);
    MaxMinSwaps maxmin(surface);
    Workspace work = workspace_of(task, first.faces.chains, surface, maxmin);
    MeasurementCache findings(work);
    std::vector<int> touched;
    Message released;
    if (restore != nullptr) {
        restore->mark_settled(first.faces.chains, work, findings.chords, options.min_angle);
    }
    separate_doubled_edges(work, touched);
    work.budget = options.budget();  // from here on, so that the first mesh may have any number of triangles
    if (options.keeps_bounds()) {
        maxmin.sweep(touched, work.settled);
        released = refine(work, findings, options, task.chord, stages);
    }

    task.progress.stage("checking", 0.9, 1.0);
    task.progress.check();
    const MaxChordError farthest = measure_against_part(work, findings, task.chord);
    const std::size_t by_chord = task.chord > 0.0 ? chord_triangles(work, findings.chords, task.chord) : 0;
    if (left == nullptr) {
        findings.chords.clear();  // released before the mesh is copied
    }
    Output out = write_out(surface, topology, task.grid.origin(), task.progress);
    task.progress.check();
    Result result;
    JoinedCorners joined(work, first.faces.chains);
    result.report = final_report(work, findings, farthest, out, joined, options, task.chord);
    result.report.chord_triangles = by_chord;
    result.mesh = std::move(out.mesh);
    result.angle_history = work.angle_history.entries();
    result.report.reused_faces = restore != nullptr ? count(restore->kept(surface), topology) : 0;
    add_note(result.report, released);
    add_note(result.report, costly_slivers(result.mesh, topology.box.largest_side()));
    report_first(first, topology, options, result.report);
    if (left != nullptr && is_cacheable(options) && result.report.complete) {
        left->faces = store(work, findings.chords, first.faces.chains, keys, task.chord, restore);
    }
    clock.end("checking");
    task.costs.report(result.report);
    return result;
}

// Whether a mesh keeps no face of the cached one, or is worse in any measure. Faces that had to be meshed again leave
// more triangles around them than meshing from scratch.
bool is_worse_than_cached(const mesh::MeshReport& now, const mesh::MeshReport& before) {
    const bool too_far = now.chord_height_asked > 0.0 && now.max_chord_height > now.chord_height_asked;
    return now.reused_faces == 0 || now.exempt.size() > before.exempt.size() ||
           now.self_intersections > before.self_intersections ||
           (too_far && now.max_chord_height > before.max_chord_height) || (!now.closed && before.closed) ||
           (!now.oriented && before.oriented) || (!now.manifold && before.manifold) || !now.complete;
}

// @param session  of in_place
Result triangulate_in_place(geometry::Session& session, const TriangulateOptions& asked, Progress& progress,
                            MeshCache* memory) {
    Costs costs(session);
    const SinglePrecisionGrid grid(session.topology().box);
    check_against_shape(asked, session.topology(), grid);
    TriangulateOptions options = asked;
    options.local_sizes = sizes_of_pieces(asked.local_sizes, session.topology());
    const double chord = options.chord_height_of(session.topology().box);
    const Task task{session, grid, options, chord, progress, costs};
    if (memory == nullptr) {
        return mesh_shape(task, {}, nullptr, nullptr);
    }
    const CacheKeys keys = keys_of(session, options);
    if (const auto same = memory->run_on(keys.input)) {
        return reuse_result(same->result, costs);
    }
    const auto before = is_cacheable(options) ? memory->nearest(keys.faces, options) : nullptr;
    auto run =
        std::make_shared<CachedRun>(CachedRun{keys.input, {}, options, chord, grid.resolution(), session.place(), {}});
    std::optional<CacheRestore> restore;
    if (before != nullptr) {
        restore.emplace(session, grid, before, keys.faces, chord);
    }
    run->result = mesh_shape(task, keys.faces, restore ? &*restore : nullptr, run.get());
    if (restore && restore->began() && is_worse_than_cached(run->result.report, before->result.report)) {
        run->faces.clear();
        run->result = mesh_shape(task, keys.faces, nullptr, run.get());
    }
    memory->add(run);
    return run->result;
}

}  // namespace

Result triangulate(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                   const TriangulateOptions& options, Progress* progress, MeshCache* memory) {
    options.validate();
    const ThreadLimit threads(options.threads);
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    Result result;
    geometry::Session(engine, model, &watched).in_place([&](geometry::Session& session) {
        result = triangulate_in_place(session, options, watched, memory);
    });
    return result;
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/simplices/curve_given.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/measuring.h"
#include "curve/volume/remeshing/local_remeshing.h"
#include "curve/volume/straighten.h"
#include "given/matching/matching.h"
#include "given/simplices/degree_raising.h"
#include "tetrahedralise/cells/tetrahedra.h"

namespace mq::given {

using curve::CurvedMesh;
using curve::CurveOptions;
using curve::CurveReport;
using curve::RepairScope;
using curve::TetrahedraInside;
using curve::TetrahedralMesh;

namespace {

/// The given tetrahedra, by vertices of the surface; the surface gets the inner vertices.
TetrahedraInside tetrahedra_of(const GivenMesh& given, MatchedMesh& matched) {
    TetrahedraInside inside;
    for (std::size_t t = 0; t < given.tetrahedra.size(); ++t) {
        if (matched.volume[t] < 0) {
            continue;
        }
        std::array<int, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k) {
            int& vertex = matched.vertex_of_node[static_cast<std::size_t>(given.tetrahedra[t][k])];
            if (vertex < 0) {
                vertex = matched.surface.add_vertex(
                    {given.nodes[static_cast<std::size_t>(given.tetrahedra[t][k])], {3, matched.volume[t]}});
            }
            corners[k] = vertex;
        }
        inside.corners.push_back(corners);
        inside.volume.push_back(matched.volume[t]);
    }
    return inside;
}

/// By corner of the result: the given node, or -1.
std::vector<std::int32_t> given_nodes(const std::vector<int>& vertex_of_node, const std::vector<int>& number,
                                      std::size_t corners) {
    std::vector<std::int32_t> result(corners, -1);
    for (std::size_t n = 0; n < vertex_of_node.size(); ++n) {
        if (vertex_of_node[n] >= 0 && number[static_cast<std::size_t>(vertex_of_node[n])] >= 0) {
            result[static_cast<std::size_t>(number[static_cast<std::size_t>(vertex_of_node[n])])] =
                static_cast<std::int32_t>(n);
        }
    }
    return result;
}

/// By element of the result: the given element with the same corners, or -1.
template <std::size_t N>
std::vector<std::int32_t> given_elements(const std::vector<std::array<int, N>>& given, const CurvedMesh& mesh,
                                         const std::vector<std::int32_t>& nodes, int width) {
    std::map<std::array<int, N>, std::int32_t> known;
    for (std::size_t i = 0; i < given.size(); ++i) {
        std::array<int, N> key = given[i];
        std::sort(key.begin(), key.end());
        known.emplace(key, static_cast<std::int32_t>(i));
    }
    std::vector<std::int32_t> result;
    for (std::size_t first = 0; first < nodes.size(); first += static_cast<std::size_t>(width)) {
        std::array<int, N> key{};
        for (std::size_t k = 0; k < N; ++k) {
            key[k] = mesh.given_node[static_cast<std::size_t>(nodes[first + k])];
        }
        std::sort(key.begin(), key.end());
        const auto met = known.find(key);
        result.push_back(met == known.end() ? -1 : met->second);
    }
    return result;
}

/// Records which elements and nodes of the result are given ones.
void compare(const GivenMesh& given, CurvedMesh& mesh, CurveReport& report) {
    report.moved_vertices = 0;
    for (std::size_t v = 0; v < mesh.vertices; ++v) {
        const std::int32_t node = mesh.given_node[v];
        if (node >= 0 && mesh.nodes[v] != given.nodes[static_cast<std::size_t>(node)]) {
            ++report.moved_vertices;
            mesh.moved_nodes.push_back(node);
        }
    }
    std::sort(mesh.moved_nodes.begin(), mesh.moved_nodes.end());
    mesh.given_element = given.tetrahedra.empty()
                             ? given_elements(given.triangles, mesh, mesh.triangles, mesh.nodes_per_triangle())
                             : given_elements(given.tetrahedra, mesh, mesh.tetrahedra, mesh.nodes_per_tetrahedron());
    const auto fresh = std::count(mesh.given_element.begin(), mesh.given_element.end(), -1);
    const std::size_t before = given.tetrahedra.empty() ? given.triangles.size() : given.tetrahedra.size();
    report.repairs.emplace_back("given elements replaced",
                                before - (mesh.given_element.size() - static_cast<std::size_t>(fresh)));
    report.repairs.emplace_back("elements in their place", static_cast<std::size_t>(fresh));
}

/// Nodes that were duplicated for a body get the numbers of the nodes that they are copies of.
void name_given_nodes(const std::vector<int>& given_node, CurvedMesh& mesh) {
    for (std::int32_t& node : mesh.given_node) {
        node = node < 0 ? node : given_node[static_cast<std::size_t>(node)];
    }
    for (std::int32_t& node : mesh.moved_nodes) {
        node = given_node[static_cast<std::size_t>(node)];
    }
    std::sort(mesh.moved_nodes.begin(), mesh.moved_nodes.end());
    mesh.moved_nodes.erase(std::unique(mesh.moved_nodes.begin(), mesh.moved_nodes.end()), mesh.moved_nodes.end());
}

/// Puts the given tetrahedra into the repaired surface. If the cavities around changed triangles cannot be filled, the
/// surface goes back to its state after placing.
void adopt_tetrahedra(std::optional<TetrahedralMesh>& volume, const GivenMesh& given, MatchedMesh& matched,
                      const MatchedMesh& placed, curve::LocalRemeshing& done, Progress& progress, CurveReport& report) {
    const std::size_t triangles_before = placed.surface.triangles.size();
    const std::vector<int> vertex_of_node = matched.vertex_of_node;
    try {
        const TetrahedraInside inside = tetrahedra_of(given, matched);
        volume.emplace(curve::remesh_locally(matched.surface, triangles_before, inside, done, progress));
    } catch (const tetrahedralise::MeshingFailed& error) {
        matched.surface = placed.surface;
        matched.vertex_of_node = vertex_of_node;
        const TetrahedraInside inside = tetrahedra_of(given, matched);
        done = {};
        volume.emplace(curve::remesh_locally(matched.surface, triangles_before, inside, done, progress));
        report.notes.push_back({phrases::kNotRepaired, {{"phrase", error.message()}}});
    }
}

/// Notes faults of the given tetrahedra in the report.
void note_faults(std::size_t turned, const MatchedMesh& matched, CurveReport& report) {
    const auto lost = std::count(matched.volume.begin(), matched.volume.end(), -1);
    if (lost > 0) {
        report.notes.push_back({phrases::kTetrahedraRemoved, {{"count", lost}}});
    }
    if (!matched.bare_faces.empty()) {
        report.notes.push_back({phrases::kBareFaces,
                                {{"count", matched.bare_faces.size()},
                                 {"name", "Face" + std::to_string(matched.bare_faces.front() + 1)}}});
    }
    if (turned > 0) {
        report.notes.push_back({phrases::kElementsTurned, {{"count", turned}}});
    }
}

/// A given mesh that was classified, curved and repaired.
struct Curving {
    Curving(geometry::Session& session, GivenMesh mesh, int order)
        : given(std::move(mesh)),
          matched(match_bodies(session, given, order)),
          editor(std::make_unique<curve::SurfaceEditor>(session, matched.surface)) {}

    GivenMesh given;
    MatchedMesh matched;
    std::unique_ptr<curve::SurfaceEditor> editor;
    std::optional<TetrahedralMesh> volume;
    std::set<int> straight_triangles;
    CurveReport report;

    TetrahedralMesh* tetrahedra() { return volume ? &*volume : nullptr; }

    std::size_t invalid() const { return matched.surface.invalid() + (volume ? volume->invalid() : 0); }
};

std::unique_ptr<Curving> curved_at(geometry::Session& session, const GivenMesh& given, const CurveOptions& options,
                                   int order, Progress& progress) {
    StageTimes seconds;
    StageTimer clock(seconds);
    progress.stage("classifying", 0.0, 0.2);
    auto curving = std::make_unique<Curving>(session, given, order);
    MatchedMesh& matched = curving->matched;
    CurveReport& report = curving->report;
    clock.end("classifying");
    progress.stage("curving the surface", 0.2, 0.4);
    curving->editor->placement.place(curve::live_triangles(matched.surface));
    const MatchedMesh placed = matched;
    clock.end("curving the surface");
    progress.stage("repairing the surface", 0.4, 0.5);
    if (options.repair) {
        curve::add_counts(curve::repair_surface(*curving->editor, progress, RepairScope::Invalid), report);
    }
    if (options.straighten) {
        curving->straight_triangles = curve::straighten_triangles(*curving->editor);
    }
    clock.end("repairing the surface");
    if (!given.tetrahedra.empty()) {
        progress.stage("filling", 0.5, 0.6);
        curve::LocalRemeshing remeshing;
        adopt_tetrahedra(curving->volume, curving->given, matched, placed, remeshing, progress, report);
        clock.end("filling");
        progress.stage("repairing the volume", 0.6, 0.95);
        curve::VolumeRepairs repairs = curve::repair_volume(*curving->volume, progress, RepairScope::Invalid);
        curve::remesh_and_repair(curving->volume, matched.surface, RepairScope::Invalid, remeshing, progress);
        repairs.cavities = static_cast<int>(remeshing.cavities);
        curve::add_counts(repairs, report);
        clock.end("repairing the volume");
    }
    report.seconds = std::move(seconds);
    return curving;
}

/// Elements of lower degree bend less. If some stay invalid, and the mesh of one degree less has fewer invalid ones,
/// takes that mesh and puts those edges and faces on the CAD with the full degree that stay valid.
void use_lower_degree_where_needed(std::unique_ptr<Curving>& curving, geometry::Session& session,
                                   const GivenMesh& given, const CurveOptions& options, Progress& progress) {
    const int order = curving->matched.surface.shapes.order();
    const std::size_t invalid = curving->invalid();
    if (order <= 2 || invalid == 0 || !options.repair || options.straighten) {
        return;
    }
    std::unique_ptr<Curving> lower = curved_at(session, given, options, order - 1, progress);
    use_lower_degree_where_needed(lower, session, given, options, progress);
    if (lower->invalid() >= invalid) {
        return;
    }
    StageTimer clock(lower->report.seconds);
    std::vector<curve::Tetrahedron> tetrahedra;
    if (lower->volume) {
        tetrahedra = std::move(lower->volume->tetrahedra);
    }
    lower->matched.surface = with_degree_raised(lower->matched.surface, tetrahedra);
    if (lower->volume) {
        lower->volume.emplace(lower->matched.surface, tetrahedra);
    }
    const std::size_t kept = place_where_valid(*lower->editor, lower->tetrahedra(), progress);
    lower->report.repairs.emplace_back("triangles of lower degree", kept);
    lower->report.seconds.insert(lower->report.seconds.begin(), curving->report.seconds.begin(),
                                 curving->report.seconds.end());
    clock.end("raising the degree");
    curving = std::move(lower);
}

}  // namespace

CurvedMesh curve_given(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model, GivenMesh given,
                       const CurveOptions& options, Progress* progress) {
    CurveOptions checked = options;
    checked.volume = !given.tetrahedra.empty();
    checked.validate();
    require_sound(given);
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    const double start = cpu_seconds();
    const std::size_t turned = orient_tetrahedra(given);
    geometry::Session session(engine, model, &watched);
    std::unique_ptr<Curving> curving = curved_at(session, given, options, options.order, watched);
    use_lower_degree_where_needed(curving, session, given, options, watched);

    CurveReport report = std::move(curving->report);
    StageTimer clock(report.seconds);
    std::vector<int> number;
    CurvedMesh result = curve::measured_mesh(*curving->editor, curving->straight_triangles, curving->tetrahedra(),
                                             session.topology(), options.straighten, report, watched, &number);
    result.given_node = given_nodes(curving->matched.vertex_of_node, number, result.vertices);
    compare(curving->given, result, report);
    name_given_nodes(curving->matched.given_node, result);
    note_faults(turned, curving->matched, report);
    clock.end("measuring");
    report.cpu_seconds = cpu_seconds() - start;
    result.report = std::move(report);
    return result;
}

}  // namespace mq::given

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/measuring.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/output/shape_distortion.h"
#include "curve/surface/enclosed_volume.h"
#include "curve/volume/straighten.h"
#include "elements/bezier/validity.h"

namespace mq::curve {

using elements::Quality;

namespace {

/// CurvedSurface figures. `invalid` adds to the count that the report has already.
/// @param straightened triangles by their index.
void measure_surface(SurfaceEditor& editor, const geometry::Topology& topology, const std::set<int>& straightened,
                     CurveReport& report) {
    const std::vector<int> triangles = live_triangles(editor.surface);
    double sum = 0.0;
    report.min_distortion = 1.0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const SurfaceTriangle& triangle = editor.triangle(triangles[i]);
        const auto name = [&] {
            return "triangle " + std::to_string(i) + " on " + topology.name_of({2, triangle.face});
        };
        if (straightened.count(triangles[i]) > 0) {
            report.straightened.push_back(name());
        }
        sum += triangle.quality;
        report.min_distortion = std::min(report.min_distortion, triangle.quality);
        if (!(triangle.quality > 0.0)) {
            ++report.invalid;
            report.invalid_elements.push_back(name());
        }
    }
    report.elements = triangles.size();
    report.mean_distortion = triangles.empty() ? 0.0 : sum / static_cast<double>(triangles.size());
    report.min_scaled_jacobian = report.min_distortion;
    const std::vector<double> distances = editor.placement.deviations(triangles);
    double squares = 0.0;
    for (const double d : distances) {
        report.max_deviation = std::max(report.max_deviation, d);
        squares += d * d;
    }
    report.rms_deviation = distances.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(distances.size()));
}

/// Names the worst of the vertices and edges that deviate from the entities at them.
void note_gaps(SurfaceEditor& editor, const geometry::Topology& topology, CurveReport& report) {
    std::map<mesh::VertexEntity, double> gaps;
    for (const int v : editor.surface.off_cad) {
        const mesh::VertexEntity& entity = editor.surface.shapes.vertices[static_cast<std::size_t>(v)].entity;
        if (!editor.surface.triangles_of_vertex(v).empty()) {
            gaps[entity] = std::max(gaps[entity], editor.placement.distance_off_cad(v));
        }
    }
    const auto worst =
        std::max_element(gaps.begin(), gaps.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    if (worst == gaps.end()) {
        return;
    }
    report.notes.push_back({gaps.size() == 1 ? phrases::kDeviatesAt : phrases::kDeviateAt,
                            {{"name", topology.name_of({worst->first[0], worst->first[1]})},
                             {"length", in_mm(worst->second, 3)},
                             {"count", gaps.size() - 1}}});
}

/// The qualities of the live tetrahedra.
std::vector<Quality> qualities_of(const TetrahedralMesh& volume, const std::vector<int>& live,
                                  const Progress& progress) {
    const elements::Lattice& lattice = elements::Lattice::of(3, volume.shapes().order());
    std::vector<Quality> qualities(live.size());
    for_chunks(static_cast<int>(live.size()), [&](int i) {
        progress.check();
        const auto k = static_cast<std::size_t>(i);
        const Tetrahedron& tetrahedron = volume.tetrahedra[static_cast<std::size_t>(live[k])];
        std::vector<Vec3> control;
        volume.shapes().tetrahedron(tetrahedron.corners, control);
        qualities[k] = elements::quality_of(elements::jacobian_of(lattice, control),
                                            volume.straight_jacobian(tetrahedron.corners));
    });
    return qualities;
}

/// Figures of the tetrahedra replace those of the surface; invalid triangles stay counted.
/// @param straightened tetrahedra by their index.
/// @return the scaled Jacobian of each live tetrahedron.
std::vector<double> measure_volume(const TetrahedralMesh& volume, const std::set<int>& straightened,
                                   CurveReport& report, const Progress& progress) {
    std::vector<double> scaled;
    const std::vector<int> live = volume.live_tetrahedra();
    const std::vector<Quality> qualities = qualities_of(volume, live, progress);
    report.elements = live.size();
    report.min_distortion = 1.0;
    report.min_scaled_jacobian = 1.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < live.size(); ++i) {
        const Tetrahedron& tetrahedron = volume.tetrahedra[static_cast<std::size_t>(live[i])];
        report.min_distortion = std::min(report.min_distortion, qualities[i].distortion);
        report.min_scaled_jacobian = std::min(report.min_scaled_jacobian, qualities[i].scaled_jacobian);
        scaled.push_back(qualities[i].scaled_jacobian);
        sum += qualities[i].distortion;
        const auto name = [&] {
            return "tetrahedron " + std::to_string(i) + " of Solid" + std::to_string(tetrahedron.volume + 1);
        };
        if (straightened.count(live[i]) > 0) {
            report.straightened.push_back(name());
        }
        if (!(tetrahedron.quality > 0.0)) {
            ++report.invalid;
            report.invalid_elements.push_back(name());
        }
    }
    report.mean_distortion = live.empty() ? 0.0 : sum / static_cast<double>(live.size());
    return scaled;
}

double largest_distortion(const CurvedMesh& mesh, bool volume, Progress& progress) {
    progress.stage("measuring the distortion", 0.95, 1.0);
    double largest = 0.0;
    for (const double d : volume ? tetrahedron_distortions(mesh, &progress) : triangle_distortions(mesh, &progress)) {
        largest = std::max(largest, d);
    }
    return largest;
}

}  // namespace

std::vector<int> live_triangles(const CurvedSurface& surface) {
    std::vector<int> result;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (surface.triangles[t].alive) {
            result.push_back(static_cast<int>(t));
        }
    }
    return result;
}

void add_counts(const SurfaceRepairs& repairs, CurveReport& report) {
    report.invalid_before += static_cast<std::size_t>(repairs.invalid_before);
    const auto add = [&](const char* name, int count) {
        report.repairs.emplace_back(name, static_cast<std::size_t>(count));
    };
    add("surface edges split for turning too far", repairs.bulge_splits);
    add("surface vertices off the CAD reached", repairs.reached);
    add("triangles that follow parameters", repairs.followed);
    add("surface edge swaps", repairs.swaps);
    add("surface edge collapses", repairs.collapses);
    add("edges curved on model faces", repairs.curved_edges);
    add("cusps opened", repairs.cusps);
    add("cusps refined", repairs.cusp_splits);
    add("faces refined around invalid triangles", repairs.refined_faces);
    add("vertices of faces put on CAD edges", repairs.snapped);
    add("surface cavities filled anew", repairs.regrown);
    add("surface edges split in repair", repairs.splits);
}

void add_counts(const VolumeRepairs& repairs, CurveReport& report) {
    report.invalid_before += static_cast<std::size_t>(repairs.invalid_before);
    report.repairs.emplace_back("edge swaps in regions", repairs.edge_swaps);
    report.repairs.emplace_back("face swaps in regions", repairs.face_swaps);
    report.repairs.emplace_back("collapses in regions", repairs.collapses);
    report.repairs.emplace_back("edges curved in regions", repairs.curved_edges);
    report.repairs.emplace_back("face nodes relocated in regions", repairs.relocated_faces);
    report.repairs.emplace_back("inner vertices relocated", repairs.relocations);
    report.moved_vertices += static_cast<std::size_t>(repairs.relocations);
    report.repairs.emplace_back("vertices put into regions", repairs.splits);
    report.repairs.emplace_back("patches of tetrahedra curved inside", repairs.patches);
    report.repairs.emplace_back("cavities filled anew", repairs.cavities);
}

CurvedMesh measured_mesh(SurfaceEditor& editor, const std::set<int>& straight_triangles, TetrahedralMesh* volume,
                         const geometry::Topology& topology, bool straighten, CurveReport& report, Progress& progress,
                         std::vector<int>* number) {
    std::vector<Tetrahedron> tetrahedra;
    std::vector<double> qualities;
    if (volume != nullptr) {
        const std::set<int> straight_tetrahedra = straighten ? straighten_tetrahedra(*volume, editor) : std::set<int>();
        measure_surface(editor, topology, straight_triangles, report);
        qualities = measure_volume(*volume, straight_tetrahedra, report, progress);
        for (const int t : volume->live_tetrahedra()) {
            tetrahedra.push_back(volume->tetrahedra[static_cast<std::size_t>(t)]);
        }
    } else {
        measure_surface(editor, topology, straight_triangles, report);
    }
    note_gaps(editor, topology, report);
    report.repairs.emplace_back("elements made straight", report.straightened.size());
    report.volume = enclosed_volume(editor.surface, topology, progress);
    CurvedMesh result = assemble(editor.surface, tetrahedra, number);
    result.tetrahedron_quality = std::move(qualities);
    for (const int t : live_triangles(editor.surface)) {
        result.triangle_quality.push_back(editor.triangle(t).quality);
    }
    report.max_shape_distortion = largest_distortion(result, volume != nullptr, progress);
    classify_on_original_entities(result, topology);
    report.vertices = result.vertices;
    return result;
}

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/curve_shape.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/injectivity/curved_crossings.h"
#include "geometry/occt/distance/shape_distance.h"
#include "geometry/occt/shape_model.h"
#include "geometry/occt/solid_volume.h"
#include "given/matching/edge_paths.h"
#include "given/matching/matching.h"
#include "given/simplices/curve_given.h"
#include "tetrahedralise/cells/tetrahedra.h"
#include "triangulate/triangulate.h"

namespace mq::workflows {

namespace {

using curve::CurvedMesh;

/// Attempts with a finer straight mesh where the first cannot be filled or stays invalid. Each can take as long as all
/// before it.
constexpr int kFiner = 3;

/// Growth rate of sizes from edges to their neighbours: invalid elements mostly lie where long edges meet short ones.
constexpr double kGrowth = 1.5;

void halve(triangulate::TriangulateOptions& options) {
    options.chord_height *= 0.5;
    options.chord_height_relative *= 0.5;
}

/// Smaller growth of sizes is tried first: it needs fewer elements than a finer mesh of the whole model.
void refine_for_validity(triangulate::TriangulateOptions& options) {
    if (options.growth == 0.0) {
        options.growth = kGrowth;
    } else {
        halve(options);
    }
}

/// Whether triangles lie on one another, as where the border of a CAD face crosses itself. Finer straight meshes lie on
/// themselves there, too, and curving cannot repair it.
bool lies_on_itself(const mesh::MeshReport& straight) {
    return !straight.oriented || straight.duplicate_triangles > 0;
}

/// @param asked the deviation that was requested of the first straight mesh, mm; taken from the first one
CurvedMesh attempt(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                   const triangulate::TriangulateOptions& straight, const curve::CurveOptions& options,
                   std::optional<double>& asked, Progress& progress) {
    StageTimes seconds;
    StageTimer clock(seconds);
    triangulate::Result mesh = triangulate::triangulate(engine, model, straight, &progress);
    clock.end("straight mesh");
    asked = asked.value_or(mesh.report.chord_height_asked);
    CurvedMesh result = curve::curve(engine, model, mesh.mesh, options, &progress);
    result.report.seconds.insert(result.report.seconds.begin(), seconds.begin(), seconds.end());
    result.straight = std::move(mesh.mesh);
    result.report.straight = std::move(mesh.report);
    result.report.chord_height_asked = *asked;
    return result;
}

CurvedMesh best_of_attempts(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                            triangulate::TriangulateOptions straight, const curve::CurveOptions& options,
                            Progress& progress) {
    std::optional<CurvedMesh> best;
    std::optional<double> asked;
    for (int times = 0;; ++times) {
        try {
            CurvedMesh mesh = attempt(engine, model, straight, options, asked, progress);
            if (times > 0) {
                mesh.report.notes.push_back({phrases::kMadeFiner, {{"count", times}}});
            }
            if (!best || mesh.report.invalid < best->report.invalid) {
                best = std::move(mesh);
            }
            if (best->report.invalid > 0 && lies_on_itself(best->report.straight)) {
                best->report.notes.emplace_back(phrases::kOnOneAnother);
                return std::move(*best);
            }
            refine_for_validity(straight);
        } catch (const tetrahedralise::MeshingFailed&) {
            if (times == kFiner && !best) {
                throw;
            }
            halve(straight);
        }
        if (times == kFiner || (best && (best->report.invalid == 0 || !options.repair))) {
            return std::move(*best);
        }
    }
}

std::shared_ptr<geometry::Model> model_of(geometry::Engine& engine, const TopoDS_Shape& shape,
                                          geometry::Creases creases, const geometry::VirtualTopology& join,
                                          Progress& progress) {
    std::shared_ptr<geometry::Model> model;
    engine.run([&] { model = geometry::make_shape_model(shape, &progress, creases, join); }, &progress);
    return model;
}

template <typename Mesh>
void measure_volume(Mesh& mesh, geometry::Engine& engine, const TopoDS_Shape& shape, Progress& progress) {
    geometry::SolidContent content;
    engine.run([&] { content = geometry::solid_content(shape, &progress); }, &progress);
    mesh.report.cad_volume = content.volume;
    mesh.report.cad_volume_error = content.error;
}

/// Number of crossing pairs of triangles that belong to different bodies, which share no node.
std::int64_t count_of_bodies(const CurvedMesh& mesh, const std::vector<curve::CurvedCrossings::Crossing>& crossing) {
    const std::size_t count = mesh.triangle_face.size();
    const std::size_t of_each = count > 0 ? mesh.triangles.size() / count : 0;
    DisjointSets<std::int32_t> joined(mesh.nodes.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        joined.unite(mesh.triangles[i - i % of_each], mesh.triangles[i]);
    }
    const auto body = [&](std::int32_t t) {
        return joined.find(mesh.triangles[of_each * static_cast<std::size_t>(t)]);
    };
    return std::count_if(crossing.begin(), crossing.end(),
                         [&](const auto& pair) { return body(pair.a) != body(pair.b); });
}

/// Counts the curved triangles that cross, and names the place of the first pair.
void find_crossings(CurvedMesh& mesh, Progress& progress) {
    progress.stage("comparing curved triangles", 1.0, 1.0);
    StageTimer clock(mesh.report.seconds);
    const curve::CurvedCrossings found = curve::curved_crossings(mesh, &progress, curve::kQuickEffort);
    clock.end("comparing curved triangles");
    mesh.report.curved_intersections = static_cast<std::int64_t>(found.crossing.size());
    mesh.report.curved_overlaps = count_of_bodies(mesh, found.crossing);
    mesh.report.not_proven_apart = static_cast<std::int64_t>(found.not_proven.size());
    const auto face_of = [&](std::int32_t triangle) {
        return mesh::entity_name(2, mesh.triangle_face[static_cast<std::size_t>(triangle)]);
    };
    if (!found.crossing.empty()) {
        const curve::CurvedCrossings::Crossing& first = found.crossing.front();
        mesh.report.notes.push_back({phrases::kCurvedCross,
                                     {{"count", found.crossing.size()},
                                      {"name", face_of(first.a)},
                                      {"name2", face_of(first.b)},
                                      {"point", in_mm(first.point)}}});
    }
    if (found.given_up > 0) {
        mesh.report.notes.push_back({phrases::kNotCompared, {{"count", found.given_up}}});
    }
}

/// Measures the mesh that is kept.
void measure_result(CurvedMesh& mesh, geometry::Engine& engine, const TopoDS_Shape& shape, Progress& progress) {
    measure_volume(mesh, engine, shape, progress);
    find_crossings(mesh, progress);
}

}  // namespace

CurvedMesh curve_shape(geometry::Engine& engine, const TopoDS_Shape& shape, const curve::CurveOptions& options,
                       const triangulate::TriangulateOptions& straight, Progress& progress) {
    options.validate();
    straight.validate();
    const ThreadLimit threads(options.threads);
    const Stopwatch watch_all;
    StageTimes seconds;
    StageTimer clock(seconds);
    progress.stage("reading the shape", 0.0, 0.0);
    const auto model = model_of(engine, shape, geometry::Creases::Cut,
                                {[&](const Box& box) { return straight.detail_of(box); }, straight.sew,
                                 straight.imprint, straight.corner_cuts()},
                                progress);
    clock.end("reading the shape");
    CurvedMesh mesh = best_of_attempts(engine, model, straight, options, progress);
    StageTimes& stages = mesh.report.seconds;
    clock.end("other straight meshes");
    for (const auto& [stage, time] : stages) {
        seconds.back().second -= time;
    }
    measure_volume(mesh, engine, shape, progress);
    clock.end("measuring the solids");
    stages.insert(stages.begin(), seconds.front());
    stages.insert(stages.end(), seconds.begin() + 1, seconds.end());
    find_crossings(mesh, progress);
    mesh.report.cpu_seconds = watch_all.cpu();
    return mesh;
}

CurvedMesh curve_surface(geometry::Engine& engine, const TopoDS_Shape& shape, const triangulate::Result& surface,
                         const curve::CurveOptions& options, Progress& progress) {
    options.validate();
    const ThreadLimit threads(options.threads);
    const bool pieces = !surface.mesh.triangle_piece.empty();
    const auto cuts = surface.report.cut_corners == 0 ? geometry::CornerCuts::None
                      : surface.report.cut_pinches    ? geometry::CornerCuts::Infeasible
                                                      : geometry::CornerCuts::All;
    const auto model = model_of(
        engine, shape, pieces ? geometry::Creases::Cut : geometry::Creases::Keep,
        {[&](const Box&) { return surface.report.detail; }, surface.report.sewn, surface.report.imprinted, cuts},
        progress);
    CurvedMesh mesh = curve::curve(engine, model, surface.mesh, options, &progress);
    mesh.straight = surface.mesh;
    mesh.report.straight = surface.report;
    mesh.report.chord_height_asked = surface.report.chord_height_asked;
    measure_result(mesh, engine, shape, progress);
    return mesh;
}

namespace {

bool has(const geometry::Model& model, geometry::Volume::Kind kind, std::ptrdiff_t least) {
    const auto& volumes = model.topology().volumes;
    return std::count_if(volumes.begin(), volumes.end(),
                         [&](const geometry::Volume& volume) { return volume.kind == kind; }) >= least;
}

/// Returns work(model of the shape). A mesh may join entities that are apart in the shape. If it does not follow the
/// model, `work` is tried again with other models: of several solids, with coincident faces of two solids as one face;
/// of faces without a shell, with their edges joined within each distance of given::kNear.
template <typename Work>
auto on_shape_as_meshed(geometry::Engine& engine, const TopoDS_Shape& shape, bool imprint, Progress& progress,
                        const Work& work) {
    const auto read = [&](const geometry::VirtualTopology& join) {
        return model_of(engine, shape, geometry::Creases::Keep, join, progress);
    };
    const auto model = read({{}, false, imprint});
    const bool may_share = !imprint && has(*model, geometry::Volume::Kind::Solid, 2);
    const bool loose = has(*model, geometry::Volume::Kind::Faces, 1);
    std::exception_ptr refusal;
    try {
        return work(model);
    } catch (const given::SolidsShareNodes&) {
        if (!may_share) {
            throw;
        }
    } catch (const TopologyError&) {
        if (!may_share && !loose) {
            throw;
        }
        refusal = std::current_exception();
    } catch (const GeometryError&) {
        if (!loose) {
            throw;
        }
        refusal = std::current_exception();
    }
    for (const double near : given::kNear) {
        if (loose) {
            try {
                return work(read({[&](const Box& box) { return near * box.largest_side(); }, true, imprint}));
            } catch (const TopologyError&) {  // a wider tolerance of gaps may do; the first refusal says what is wrong
            } catch (const GeometryError&) {
            }
        }
    }
    if (!may_share) {
        std::rethrow_exception(refusal);
    }
    return work(read({{}, false, true}));
}

}  // namespace

CurvedMesh curve_given_mesh(geometry::Engine& engine, const TopoDS_Shape& shape, const given::GivenMesh& given,
                            const curve::CurveOptions& options, bool imprint, Progress& progress) {
    const ThreadLimit threads(options.threads);
    progress.stage("reading the shape", 0.0, 0.0);
    return on_shape_as_meshed(engine, shape, imprint, progress, [&](const auto& model) {
        CurvedMesh mesh = given::curve_given(engine, model, given, options, &progress);
        measure_result(mesh, engine, shape, progress);
        return mesh;
    });
}

given::CurvedMixedMesh curve_mixed_mesh(geometry::Engine& engine, const TopoDS_Shape& shape,
                                        const given::MixedMesh& given, const curve::CurveOptions& options, bool imprint,
                                        Progress& progress) {
    const ThreadLimit threads(options.threads);
    progress.stage("reading the shape", 0.0, 0.0);
    return on_shape_as_meshed(engine, shape, imprint, progress, [&](const auto& model) {
        given::CurvedMixedMesh mesh = given::curve_mixed(engine, model, given, options, &progress);
        if (given.has_volume()) {
            measure_volume(mesh, engine, shape, progress);
        }
        return mesh;
    });
}

given::GivenSurfaceMeasures measure_given_surface(geometry::Engine& engine, const TopoDS_Shape& shape,
                                                  const std::vector<Vec3>& nodes, int order,
                                                  const std::vector<std::int32_t>& triangles, Progress& progress) {
    return on_shape_as_meshed(engine, shape, false, progress, [&](const auto& model) {
        return given::measure_given_surface(engine, model, nodes, order, triangles, &progress);
    });
}

given::CadDistances cad_distances(geometry::Engine& engine, const TopoDS_Shape& shape, const std::vector<Vec3>& nodes,
                                  int order, const std::vector<std::int32_t>& triangles, Progress& progress) {
    const auto model = model_of(engine, shape, geometry::Creases::Keep, {{}, false, false}, progress);
    return given::cad_distances(engine, model, nodes, order, triangles, &progress);
}

std::vector<double> distances_to_faces(geometry::Engine& engine, const TopoDS_Shape& shape,
                                       const std::vector<Vec3>& points, Progress& progress) {
    std::vector<double> found;
    engine.run([&] { found = geometry::distances_to_faces(shape, points, &progress); }, &progress);
    return found;
}

}  // namespace mq::workflows

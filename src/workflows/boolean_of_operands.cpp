// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/boolean_of_operands.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "boolean/input/operand_repair.h"
#include "boolean/project_to_cad.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/shape_model.h"
#include "layered_depth/sound_layered_depth.h"
#include "mesh/quality/exemptions.h"
#include "workflows/operands/operand_frame.h"

namespace mq::workflows {

namespace {

using boolean::BooleanOptions;
using boolean::BooleanResult;
using boolean::Expression;
using boolean::Operation;
using layered_depth::UniformResult;

void assign(BooleanSurface& surface, BooleanResult&& result) {
    BooleanReport& figures = surface.figures;
    figures.error_bound = result.error_bound;
    figures.retained = result.retained;
    figures.reconstructed = result.reconstructed;
    figures.faults_left = result.faults_left;
    figures.self_intersections = 0;  // otherwise an error is thrown
    figures.crossing_pairs = result.crossing_pairs;
    figures.curve_edges = result.curve_edges;
    figures.separated_contacts = result.separated_contacts;
    figures.closed_gaps = result.closed_gaps;
    figures.operands = std::move(result.operand_topology);
    figures.separated_vertices = result.separated_vertices;
    std::copy_if(result.repaired.begin(), result.repaired.end(), std::back_inserter(figures.repaired),
                 [](const Message& sentence) { return !sentence.empty(); });
    figures.notes = std::move(result.notes);
    figures.seconds = std::move(result.seconds);
    surface.mesh = std::move(result.mesh);
    surface.triangle_source = std::move(result.triangle_source);
    surface.triangle_origin = std::move(result.triangle_origin);
}

/// The share of the result's samples that no triangle of an operand has.
double guessed_share(const UniformResult& result) {
    return static_cast<double>(result.guessed_samples) /
           static_cast<double>(std::max<std::size_t>(1, result.result_samples));
}

/// A sentence on the open operands, and on how much of the result is a guess.
Message guess(const UniformResult& result) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < result.open.size(); ++k) {
        if (result.open[k] != 0) {
            names.push_back(boolean::operand_name(k, result.open.size()));
        }
    }
    return {phrases::kGuess, {{"list", mesh::list_of(names)}, {"number", in_digits(100.0 * guessed_share(result), 2)}}};
}

/// A sentence on the samples that the rays found on the faces of shapes.
Message samples_of_faces(const UniformResult& result) {
    const layered_depth::FaceSampleCounts& cad = result.cad;
    std::vector<Message> said{counted(phrases::kSampledOnFaces, cad.on_faces)};
    if (cad.on_mesh > 0) {
        said.push_back(counted(phrases::kSampledOnMeshes, cad.on_mesh));
    }
    if (cad.nodes.left > 0) {
        said.push_back(counted(phrases::kRaysDisagree, cad.nodes.left));
    }
    return mesh::list_of(said);
}

void assign(BooleanSurface& surface, UniformResult&& result) {
    BooleanReport& figures = surface.figures;
    figures.method = "uniform";
    figures.error_bound = result.error_bound;
    figures.retained = result.retained;
    figures.reconstructed = result.mesh.triangles.size() - result.retained;
    figures.self_intersections = 0;  // otherwise an error is thrown
    figures.crossing_pairs = result.crossing_pairs;
    if (result.unsampled_triangles > 0) {
        figures.notes.push_back(counted(phrases::kLost, result.unsampled_triangles));
    }
    if (result.holes_filled > 0) {
        figures.notes.push_back(counted(phrases::kFilled, result.holes_filled));
    }
    if (result.cad.on_faces + result.cad.on_mesh > 0) {
        figures.notes.push_back(samples_of_faces(result));
    }
    if (std::any_of(result.open.begin(), result.open.end(), [](char open) { return open != 0; })) {
        figures.notes.push_back(guess(result));
    }
    figures.guessed_share = guessed_share(result);
    std::copy_if(result.repaired.begin(), result.repaired.end(), std::back_inserter(figures.repaired),
                 [](const Message& sentence) { return !sentence.empty(); });
    figures.samples = result.samples;
    figures.holes_filled = result.holes_filled;
    figures.face_samples = result.cad.on_faces;
    figures.fitted_vertices = result.fitted;
    figures.unfitted_vertices = result.unfitted;
    figures.seconds = std::move(result.seconds);
    surface.mesh = std::move(result.mesh);
    surface.triangle_source = std::move(result.triangle_source);
    surface.triangle_origin = surface.triangle_source;
}

/// The shapes of the operands that have one, for rays that meet their faces.
layered_depth::CadOperands cad_of(const std::vector<BooleanOperand>& operands, geometry::Engine& engine,
                                  const Progress& progress) {
    layered_depth::CadOperands cad;
    cad.engine = &engine;
    cad.shapes.resize(operands.size());
    for (std::size_t i = 0; i < cad.shapes.size(); ++i) {
        const BooleanOperand& operand = operands[i];
        if (operand.shape != nullptr &&
            operand.surface->mesh.triangle_face.size() == operand.surface->mesh.triangles.size()) {
            engine.run([&] { cad.shapes[i].model = geometry::make_shape_model(*operand.shape, &progress); }, &progress);
            cad.shapes[i].faces = &operand.surface->mesh.triangle_face;
            cad.shapes[i].chord_height = operand.surface->report.max_chord_height;
        }
    }
    return cad;
}

void run_uniform(BooleanSurface& surface, const OperandFrame& frame, const std::vector<BooleanOperand>& operands,
                 geometry::Engine& engine, const Expression& expression, const BooleanOptions& options,
                 Progress& progress) {
    layered_depth::LayeredDepthOptions uniform;
    uniform.resolution = options.resolution;
    uniform.full = options.full;
    double tolerance = options.tolerance;
    if (tolerance > 0.0) {
        uniform.resolution = layered_depth::uniform_resolution(frame.size(), tolerance);
    } else {
        tolerance = layered_depth::uniform_bound(frame.size(), uniform.resolution);
    }
    const layered_depth::CadOperands cad = cad_of(operands, engine, progress);
    assign(surface,
           layered_depth::sound_layered_depth_boolean(frame.meshes(), expression, uniform, tolerance, progress, cad));
    surface.figures.tolerance_asked = tolerance;
}

/// Edges, vertices and triangles at which a surface is not a closed oriented manifold.
std::size_t surface_faults(const mesh::MeshReport& report) {
    return report.border_edges + report.nonmanifold_edges + report.misoriented_edges + report.pinched_vertices +
           report.degenerate_triangles + report.duplicate_triangles;
}

/// Projects vertices made on faces of shapes onto their surfaces. No vertex moves farther than `limit`, mm.
void fit_to_shapes(BooleanSurface& surface, const OperandFrame& frame, const std::vector<BooleanOperand>& operands,
                   geometry::Engine& engine, double limit, Progress& progress) {
    constexpr double kSinglePrecision = 5e-7;  // fraction of the size: a few steps of single precision
    if (std::none_of(operands.begin(), operands.end(), [](const BooleanOperand& o) { return o.shape != nullptr; })) {
        return;
    }
    const Stopwatch fitting;
    progress.stage("fitting to the shapes", 1.0, 1.0);
    std::vector<boolean::CadOperand> native(operands.size());
    for (std::size_t i = 0; i < operands.size(); ++i) {
        native[i].mesh = frame.meshes()[i];
        native[i].faces = &operands[i].surface->mesh.triangle_face;
        if (operands[i].shape != nullptr) {
            engine.run([&] { native[i].model = geometry::make_shape_model(*operands[i].shape, &progress); }, &progress);
        }
    }
    BooleanReport& figures = surface.figures;
    const double near = figures.error_bound + kSinglePrecision * frame.size();
    const boolean::CadProjection fit =
        boolean::project_to_cad(surface.mesh, surface.triangle_source, native, engine, near, limit, progress);
    figures.fitted_vertices = fit.moved;
    figures.unfitted_vertices = fit.reverted + fit.left;
    figures.error_bound += fit.largest_move;
    figures.seconds.emplace_back("fitting to the shapes", fitting.wall());
}

}  // namespace

void complete_report(BooleanSurface& surface, const WorkBefore& before, const Message& empty, Progress& progress) {
    BooleanReport& figures = surface.figures;
    const Stopwatch measuring;
    auto notes = std::move(figures.notes);
    auto seconds = std::move(figures.seconds);
    const std::int64_t crossings = figures.self_intersections;
    static_cast<mesh::MeshReport&>(figures) = mesh::measure(surface.mesh, &progress);
    figures.self_intersections = crossings;
    figures.error_bound += before.error_bound;
    if (before.tolerance > 0.0) {
        figures.tolerance_asked = before.tolerance;
    }
    if (surface.mesh.triangles.empty()) {
        notes.insert(notes.begin(), empty);
    } else if (!figures.closed || !figures.oriented || !figures.manifold) {
        notes.insert(notes.begin(), Message(phrases::kNotManifold));
        figures.faults_left = std::max(figures.faults_left, surface_faults(figures));
    }
    notes.insert(notes.begin(), before.notes.begin(), before.notes.end());
    figures.repaired.insert(figures.repaired.begin(), before.repaired.begin(), before.repaired.end());
    seconds.insert(seconds.begin(), before.seconds.begin(), before.seconds.end());
    add_time(seconds, "measuring", measuring.wall());
    figures.notes = std::move(notes);
    figures.seconds = std::move(seconds);
}

namespace {

void require_valid(const BooleanOptions& options, BooleanMethod method) {
    options.validate();
    if (options.full && method != BooleanMethod::Uniform) {
        throw InvalidInput(phrases::kFullBySampling);
    }
}

/// One Boolean by either method.
class BooleanRun {
  public:
    BooleanRun(geometry::Engine& engine, const std::vector<BooleanOperand>& operands, const OperandFrame& frame,
               const Expression& expression, const BooleanOptions& options, Progress& progress)
        : engine_(engine),
          operands_(operands),
          frame_(frame),
          expression_(expression),
          options_(options),
          progress_(progress) {}

    BooleanSurface exact() const {
        BooleanSurface result;
        const double limit = options_.tolerance_for(frame_.size());
        assign(result, boolean::boolean(frame_.meshes(), expression_, options_, &progress_));
        result.figures.tolerance_asked = limit;
        fit_to_shapes(result, frame_, operands_, engine_, limit, progress_);
        return result;
    }

    BooleanSurface uniform() const {
        BooleanSurface result;
        run_uniform(result, frame_, operands_, engine_, expression_, options_, progress_);
        return result;
    }

    BooleanSurface exact_or_uniform() const {
        try {
            return exact();
        } catch (const boolean::OpenOperand& error) {
            return uniform_after(error);
        } catch (const TopologyError& error) {
            return uniform_after(error);
        }
    }

  private:
    template <typename Kind>
    BooleanSurface uniform_after(const Kind& error) const {
        const auto fails = [&](const Error& neither) {
            return Kind(phrases::kSamplingFailsToo, {{"phrase", error.message()}, {"phrase2", neither.message()}});
        };
        BooleanSurface result;
        try {
            result = uniform();
        } catch (const InvalidInput& neither) {
            throw fails(neither);
        } catch (const TopologyError& neither) {
            throw fails(neither);
        }
        result.figures.notes.insert(result.figures.notes.begin(),
                                    Message(phrases::kNoExactResult, {{"phrase", error.message()}}));
        return result;
    }

    geometry::Engine& engine_;
    const std::vector<BooleanOperand>& operands_;
    const OperandFrame& frame_;
    const Expression& expression_;
    const BooleanOptions& options_;
    Progress& progress_;
};

}  // namespace

BooleanSurface boolean_of_operands(geometry::Engine& engine, const std::vector<BooleanOperand>& operands,
                                   const Expression& expression, const BooleanOptions& options, BooleanMethod method,
                                   const WorkBefore& before, Progress& progress) {
    require_valid(options, method);
    const ThreadLimit threads(options.threads);
    const Stopwatch watch_all;
    std::vector<FramedOperand> framed;
    for (const BooleanOperand& operand : operands) {
        framed.push_back({&operand.surface->mesh, operand.round});
    }
    const OperandFrame frame(framed);
    const BooleanRun run(engine, operands, frame, expression, options, progress);
    BooleanSurface result = method == BooleanMethod::Uniform ? run.uniform()
                            : method == BooleanMethod::Exact ? run.exact()
                                                             : run.exact_or_uniform();
    if (!frame.single()) {
        result.figures.notes.emplace_back(phrases::kManyDigits);
    }
    result.figures.operands.resize(operands.size());
    parallel_for(static_cast<int>(operands.size()), [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        if (result.figures.operands[i].components == 0) {
            result.figures.operands[i] = mesh::topology_of(operands[i].surface->mesh);
        }
    });
    complete_report(result, before,
                    expression.chained() == Operation::SymmetricDifference
                        ? Message(phrases::kNoDifference, {{"length", in_mm(result.figures.tolerance_asked)}})
                        : phrases::kNoVolumeLeft,
                    progress);
    result.figures.cpu_seconds = before.cpu_seconds + watch_all.cpu();
    result.report = result.figures;
    return result;
}

BooleanSurface boolean_of_operands(const Operands& operands, const Expression& expression, BooleanOptions options,
                                   BooleanMethod method, Progress& progress) {
    constexpr double kMeshing = 0.4;  // fraction of the progress
    constexpr double kShare = 0.25;
    constexpr double kShareUniform = 1.0 / 16.0;
    // The tolerance of a resolution goes by the largest operand, and may be a tenth of the radius of a slender one.
    constexpr double kVolumeError = 0.002;
    require_valid(options, method);
    const bool is_uniform = method == BooleanMethod::Uniform;
    const bool is_given = options.tolerance > 0.0;
    if (!is_uniform && !is_given) {
        options.length = operands.divided_length();
    }
    OperandMeshing meshing;
    meshing.tolerance = options.tolerance_for(operands.size());
    meshing.share = is_uniform ? kShareUniform : kShare;
    meshing.volume_error = is_given ? 0.0 : kVolumeError;
    meshing.threads = options.threads;
    MeshedOperands meshed = operands.meshed(meshing, progress, 0.0, kMeshing);
    meshed.work.error_bound = 0.0;  // in the notes only: the reported bound refers to the operands' meshes
    const ProgressShare rest(progress, operands.any_shapes() ? kMeshing : 0.0, 1.0);
    return boolean_of_operands(operands.engine(), meshed.operands, expression, options, method, meshed.work, progress);
}

void name_faces(BooleanSurface& result, const std::vector<const triangulate::Result*>& operands) {
    std::vector<std::int32_t> faces;
    for (const auto& [operand, triangle] : result.triangle_origin) {
        const std::vector<std::int32_t>* own =
            operand < 0 ? nullptr : &operands[static_cast<std::size_t>(operand)]->mesh.triangle_face;
        faces.push_back(own == nullptr || own->empty() ? -1 : (*own)[static_cast<std::size_t>(triangle)]);
    }
    const bool any = std::any_of(faces.begin(), faces.end(), [](std::int32_t face) { return face >= 0; });
    result.mesh.triangle_face = any ? std::move(faces) : std::vector<std::int32_t>();
}

}  // namespace mq::workflows

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/operands/mesh_operands.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "boolean/boolean.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/mean_thickness.h"
#include "geometry/occt/shape_model.h"
#include "workflows/operands/distance_mesh.h"
#include "workflows/operands/triangulate_shape.h"

namespace mq::workflows {

namespace {

using triangulate::Result;

// Triangulating asks for at least 4 times the rounding error of single precision, which is sqrt(3) times 2^-24 of the
// largest coordinate in the local frame of the shape. That frame keeps coordinates within 4 times the shape's size.
const double kFinestChord = 4.0 * std::sqrt(3.0) * std::ldexp(1.0, -24);
constexpr double kFrame = 4.0;

/// The error with the name of the operand before it, unless that is in it.
template <typename Kind>
Kind named(const std::string& name, const Kind& error) {
    const bool says = std::string(error.what()).find(name) != std::string::npos;
    return says ? error : Kind(phrases::kNamed, {{"name", name}, {"phrase", error.message()}});
}

Result complete(geometry::Engine& engine, const TopoDS_Shape& shape, const triangulate::TriangulateOptions& options,
                Progress& progress) {
    Result mesh = triangulate_shape(engine, shape, options, progress);
    require_complete(mesh.report, options.chord_height);
    return mesh;
}

/// Returns a mesh fine enough for `how.volume_error`, and its relative error of volume. That is proportional to the
/// chord height: two meshes give the factor (Richardson's extrapolation).
std::pair<Result, double> keeping_volume(geometry::Engine& engine, const TopoDS_Shape& shape,
                                         triangulate::TriangulateOptions options, const OperandMeshing& how,
                                         Progress& progress) {
    constexpr double kCoarse = 4.0;       // how much coarser the first mesh is, by which the error is found
    constexpr int kMostFiner = 3;         // how often a finer one is made
    constexpr double kAccepted = 0.85;    // the error that is accepted, as a fraction of the one that is allowed, ...
    constexpr double kAim = 0.75;         // ... and the one that is aimed at
    constexpr double kStep = 1.0 / 32.0;  // how much finer at most in one step
    const double error = how.volume_error;
    const double chord_height = options.chord_height;
    const auto meshed = [&](int step, double height) {
        const double share = 1.0 / (kMostFiner + 2);
        const ProgressShare part(progress, step * share, (step + 1) * share);
        options.chord_height = height;
        return complete(engine, shape, options, progress);
    };
    Result coarse = meshed(0, kCoarse * chord_height);
    if (coarse.report.max_chord_height <= 0.0) {
        return {std::move(coarse), 0.0};  // all faces are plane, and their edges straight
    }
    if (!coarse.report.closed) {
        return {meshed(1, chord_height), 0.0};
    }
    double longer = kCoarse * chord_height;
    double height = chord_height;
    for (int step = 1;; ++step) {
        Result mesh = meshed(step, height);
        const double volume = std::abs(mesh.report.volume);
        const double found = std::abs(volume - std::abs(coarse.report.volume)) * height / (longer - height);
        const double finer = std::max(kAim * error * volume / found, kStep);
        if (found <= kAccepted * error * volume || step > kMostFiner ||
            static_cast<double>(mesh.report.triangles) > finer * how.most_triangles) {
            return {std::move(mesh), found / volume};
        }
        coarse = std::move(mesh);
        longer = height;
        height *= finer;
    }
}

/// A mesh that overlaps another one: both enclose together what each of them does.
Result joined(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) {
    Result result;
    append(result.mesh, a);
    append(result.mesh, b);
    result.mesh.triangle_face.clear();
    return result;
}

/// Meshes the shapes one after the other, and collects the deviations of the meshes.
class ShapeMesher {
  public:
    ShapeMesher(geometry::Engine& engine, const OperandMeshing& how, Progress& progress)
        : engine_(engine), how_(how), progress_(progress) {}

    /// @param box  of its shape
    void mesh(const GivenOperand& given, const Box& box, MeshedOperands& result) {
        const double largest = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
        const double chord_height =
            std::max(how_.share * how_.tolerance, kFinestChord * std::min(largest, kFrame * box.largest_side()));
        DistanceMesh found;
        try {
            found = how_.any_faces ? mesh_within(engine_, *given.shape, chord_height, how_.threads, progress_)
                                   : of_all_faces(given, chord_height);
        } catch (const InvalidInput& error) {
            throw named(given.name, error);
        } catch (const TopologyError& error) {
            throw named(given.name, error);
        }
        result.work.error_bound = std::max(result.work.error_bound, found.deviation);
        for (const Message& note : found.notes) {
            result.work.notes.push_back(
                how_.any_faces ? Message(phrases::kOfOperand, {{"name", given.name}, {"phrase", note}}) : note);
        }
        const bool is_mixed = given.surface != nullptr;
        result.surfaces.push_back(std::make_shared<Result>(is_mixed ? joined(found.surface.mesh, given.surface->mesh)
                                                                    : std::move(found.surface)));
        result.operands.push_back({nullptr, is_mixed || found.round, is_mixed ? nullptr : given.shape.get()});
    }

    /// A note for each operand that has nothing else to tell, for many of them one.
    void note_deviations(std::vector<Message>& notes) const {
        constexpr std::size_t kMostNotes = 3;
        if (deviations_.size() > kMostNotes) {
            double largest = 0.0;
            for (const auto& [name, deviation] : deviations_) {
                largest = std::max(largest, deviation);
            }
            notes.push_back({phrases::kShapesDeviate, {{"count", deviations_.size()}, {"length", in_mm(largest, 3)}}});
            return;
        }
        for (const auto& [name, deviation] : deviations_) {
            notes.push_back({phrases::kShapeDeviates[0], {{"name", name}, {"length", in_mm(deviation, 3)}}});
        }
    }

  private:
    DistanceMesh of_all_faces(const GivenOperand& given, double chord_height) {
        triangulate::TriangulateOptions options;
        options.min_angle = how_.min_angle;
        options.chord_height = chord_height;
        options.threads = how_.threads;
        DistanceMesh found;
        double volume_error = 0.0;
        if (how_.volume_error > 0.0) {
            std::tie(found.surface, volume_error) = keeping_volume(engine_, *given.shape, options, how_, progress_);
        } else {
            found.surface = complete(engine_, *given.shape, options, progress_);
        }
        found.deviation = found.surface.report.max_chord_height;
        const bool errs = volume_error > (how_.volume_error > 0.0 ? how_.volume_error : 1.0);
        const bool is_mixed = given.surface != nullptr;
        if (!is_mixed && !errs) {
            deviations_.emplace_back(given.name, found.deviation);
            return found;
        }
        found.notes.push_back({(is_mixed ? phrases::kMixedDeviates : phrases::kShapeDeviates)[errs ? 1 : 0],
                               {{"name", given.name},
                                {"length", in_mm(found.deviation, 3)},
                                {"number", in_digits(100.0 * volume_error, 2)}}});
        return found;
    }

    geometry::Engine& engine_;
    const OperandMeshing& how_;
    Progress& progress_;
    std::vector<std::pair<std::string, double>> deviations_;
};

}  // namespace

void Operands::add(GivenOperand operand) {
    given_.push_back(std::move(operand));
    boxes_.emplace_back();
    read_wall_ = watch_.wall();
    read_cpu_ = watch_.cpu();
}

bool Operands::any_shapes() const {
    return std::any_of(given_.begin(), given_.end(), [](const GivenOperand& o) { return o.shape != nullptr; });
}

std::string Operands::bridge() const {
    const auto shape = std::find_if(given_.begin(), given_.end(), [](const auto& one) { return !one.bridge.empty(); });
    return shape == given_.end() ? "" : shape->bridge;
}

const Box& Operands::box_of_shape(std::size_t operand) const {
    std::optional<Box>& box = boxes_[operand];
    if (!box) {
        try {
            engine_.run([&] { box = geometry::box_of_shape(*given_[operand].shape); });
        } catch (const InvalidInput& error) {
            throw named(given_[operand].name, error);
        }
    }
    return *box;
}

double Operands::size() const {
    Box box;
    for (std::size_t i = 0; i < given_.size(); ++i) {
        const GivenOperand& operand = given_[i];
        if (operand.shape) {
            box.add(box_of_shape(i));
        }
        if (operand.surface) {
            for (const Vec3& p : operand.surface->mesh.vertices) {
                // Coordinates that are not finite are left to the operation, which names the operand and the vertex.
                if (p.allFinite()) {
                    box.add(p + operand.surface->mesh.origin);
                }
            }
        }
    }
    return box.largest_side();
}

double Operands::divided_length() const {
    constexpr double kThicknesses = 8.0;
    constexpr double kShortest = 1.0 / 16.0;  // bounds what slender operands cost
    const double whole = size();
    double thin = whole;
    for (const GivenOperand& operand : given_) {
        std::vector<double> found;
        if (operand.shape) {
            engine_.run([&] { found = geometry::mean_thicknesses(*operand.shape); });
        }
        if (operand.surface) {
            found.push_back(mesh::mean_thickness(operand.surface->mesh));
        }
        for (const double thickness : found) {
            thin = thickness > 0.0 ? std::min(thin, thickness) : thin;
        }
    }
    return std::min(whole, std::max(kThicknesses * thin, kShortest * whole));
}

MeshedOperands Operands::meshed(const OperandMeshing& meshing, Progress& progress, double from, double to) const {
    const ProgressShare all(progress, from, to);
    MeshedOperands result;
    result.work.seconds.emplace_back("reading the operands", read_wall_);
    const Stopwatch watch;
    if (any_shapes()) {
        boolean::require_possible(meshing.tolerance, size());  // before shapes are meshed as finely
    }
    ShapeMesher mesher(engine_, meshing, progress);
    const auto shapes = static_cast<double>(
        std::count_if(given_.begin(), given_.end(), [](const GivenOperand& o) { return o.shape != nullptr; }));
    double done = 0.0;
    for (std::size_t i = 0; i < given_.size(); ++i) {
        const GivenOperand& operand = given_[i];
        if (operand.shape) {
            const ProgressShare part(progress, done / shapes, (done + 1.0) / shapes);
            mesher.mesh(operand, box_of_shape(i), result);
            done += 1.0;
        } else {
            result.surfaces.push_back(operand.surface);
            result.operands.push_back({nullptr, operand.round, nullptr});
        }
        result.operands.back().surface = result.surfaces.back().get();
    }
    mesher.note_deviations(result.work.notes);
    if (shapes > 0.0) {
        result.work.seconds.emplace_back("meshing shapes", watch.wall());
    }
    result.work.cpu_seconds = read_cpu_ + watch.cpu();
    return result;
}

}  // namespace mq::workflows

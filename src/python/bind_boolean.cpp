// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "base/error.h"
#include "base/stage_clock.h"
#include "boolean/boolean.h"
#include "boolean/native_surfaces.h"
#include "boolean/uniform.h"
#include "boolean/verification.h"
#include "geometry/occt/shape_model.h"
#include "mesh/report.h"
#include "mesh/surface_distance.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/engine.h"
#include "python/operand_frame.h"
#include "python/part_shape.h"
#include "python/stopwatch.h"
#include "python/watch.h"
#include "triangulate/triangulate.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using boolean::BooleanOptions;
using boolean::BooleanResult;
using boolean::Operation;
using boolean::UniformResult;
using Surface = triangulate::Result;
using SurfacePointer = std::shared_ptr<Surface>;

/// What a MeshReport says, and what happened to the operands.
struct BooleanReport : mesh::MeshReport {
    double error_bound = 0.0;
    double tolerance_asked = 0.0;
    std::size_t retained = 0;
    std::size_t reconstructed = 0;
    std::size_t faults_left = 0;
    std::size_t crossing_pairs = 0;
    std::size_t curve_edges = 0;
    std::size_t parted_contacts = 0;
    std::size_t separated_vertices = 0;
    std::size_t fitted_vertices = 0;
    std::size_t unfitted_vertices = 0;
    std::vector<std::string> repaired;  ///< a sentence for each operand that was repaired
};

/// `report` of the base class holds the measured part of `figures`.
struct BooleanSurface : Surface {
    BooleanReport figures;
    std::vector<std::array<std::int32_t, 2>> triangle_source;
};

static_assert(sizeof(std::array<std::int32_t, 2>) == 2 * sizeof(std::int32_t), "handed to NumPy as it lies in memory");

/// What was done before the core was called: reading and meshing the operands.
struct Before {
    StageTimes seconds;
    std::vector<std::string> notes;
    double cpu_seconds = 0.0;
};

constexpr const char* kDefault = "default";
constexpr const char* kUniform = "uniform";

void take(BooleanSurface& surface, BooleanResult&& result) {
    BooleanReport& figures = surface.figures;
    figures.error_bound = result.error_bound;
    figures.retained = result.retained;
    figures.reconstructed = result.reconstructed;
    figures.faults_left = result.faults_left;
    figures.crossing_pairs = result.crossing_pairs;
    figures.curve_edges = result.curve_edges;
    figures.parted_contacts = result.parted_contacts;
    figures.separated_vertices = result.separated_vertices;
    std::copy_if(result.repaired.begin(), result.repaired.end(), std::back_inserter(figures.repaired),
                 [](const std::string& sentence) { return !sentence.empty(); });
    figures.notes = std::move(result.notes);
    figures.seconds = std::move(result.seconds);
    surface.mesh = std::move(result.mesh);
    surface.triangle_source = std::move(result.triangle_source);
}

void take(BooleanSurface& surface, UniformResult&& result) {
    BooleanReport& figures = surface.figures;
    figures.error_bound = result.error_bound;
    figures.retained = result.retained;
    figures.reconstructed = result.changed + result.reconstructed + result.hole_triangles;
    if (result.unsampled_triangles > 0) {
        figures.notes.push_back("lost, as no ray met the components that they belong to: " +
                                mesh::counted(result.unsampled_triangles, "triangle") + "; take a higher resolution");
    }
    if (result.holes_filled > 0) {
        figures.notes.push_back("filled in the reconstruction: " + mesh::counted(result.holes_filled, "hole"));
    }
    figures.seconds = std::move(result.seconds);
    surface.mesh = std::move(result.mesh);
    surface.triangle_source = std::move(result.triangle_source);
}

/// The paper's scheme promises no freedom from self-intersection, so its result is checked here.
void check_uniform(BooleanSurface& surface, Progress& progress) {
    const boolean::Verification check =
        boolean::verify(surface.mesh.vertices, surface.mesh.triangles, nullptr, 1000, &progress);
    for (const std::size_t count : check.count) {
        surface.figures.faults_left += count;
    }
    surface.figures.self_intersections =
        static_cast<std::int64_t>(check.count[static_cast<std::size_t>(boolean::FaultKind::Crossing)]);
    if (!check.passed()) {
        surface.figures.notes.push_back("the uniform scheme left faults: " + check.summary(surface.mesh.origin));
    }
}

void run_uniform(BooleanSurface& surface, const OperandFrame& frame, Operation operation, const BooleanOptions& options,
                 Progress& progress) {
    if (frame.meshes().size() != 2) {
        throw InvalidInput("method 'uniform' takes two operands, not " + std::to_string(frame.meshes().size()) +
                           ": use method 'default', or apply it to two at a time");
    }
    boolean::UniformOptions uniform;
    uniform.resolution = options.resolution;
    double tolerance = options.tolerance;
    if (tolerance > 0.0) {
        uniform.resolution = boolean::uniform_resolution(frame.size(), tolerance);
    } else {
        tolerance = boolean::uniform_bound(frame.size(), uniform.resolution);
    }
    take(surface,
         boolean::layered_depth_boolean(*frame.meshes()[0], *frame.meshes()[1], operation, uniform, &progress));
    surface.figures.tolerance_asked = tolerance;
    check_uniform(surface, progress);
}

/// Edges, vertices and triangles at which a surface is not a closed oriented manifold.
std::size_t surface_faults(const mesh::MeshReport& report) {
    return report.border_edges + report.nonmanifold_edges + report.misoriented_edges + report.pinched_vertices +
           report.degenerate_triangles + report.duplicate_triangles;
}

/// Fills what every report has, and what the caller did before.
void measure(BooleanSurface& surface, const OperandFrame& frame, Operation operation, const Before& before,
             Progress& progress) {
    BooleanReport& figures = surface.figures;
    const Stopwatch measuring;
    auto notes = std::move(figures.notes);
    auto seconds = std::move(figures.seconds);
    const std::int64_t crossings = figures.self_intersections;
    static_cast<mesh::MeshReport&>(figures) = mesh::measure(surface.mesh, &progress);
    figures.self_intersections = crossings;
    if (surface.mesh.triangles.empty() && operation == Operation::SymmetricDifference) {
        std::array<char, 160> text;
        std::snprintf(text.data(), text.size(),
                      "the result is empty: the operands are the same within the tolerance of %.4g mm; a smaller "
                      "tolerance shows smaller differences",
                      figures.tolerance_asked);
        notes.emplace_back(text.data());
    } else if (surface.mesh.triangles.empty()) {
        notes.emplace_back("the result is empty: no volume is left");
    } else if (!figures.closed || !figures.oriented || !figures.manifold) {
        notes.emplace_back("the result is not a closed manifold surface: see its faults");
        figures.faults_left = std::max(figures.faults_left, surface_faults(figures));
    }
    if (!frame.single()) {
        notes.emplace_back(
            "an operand has more digits than single precision holds: to_mesh and most files round the result");
    }
    notes.insert(notes.begin(), before.notes.begin(), before.notes.end());
    seconds.insert(seconds.begin(), before.seconds.begin(), before.seconds.end());
    seconds.emplace_back("measuring", measuring.wall());
    figures.notes = std::move(notes);
    figures.seconds = std::move(seconds);
}

/// An operand as it comes from Python: whether it may be rounded to single precision, and the Part.Shape that it was
/// made of, or None.
using PythonOperand = std::tuple<SurfacePointer, bool, py::object>;

/// Puts what was made on faces of shapes onto their surfaces.
void fit_to_shapes(BooleanSurface& surface, const OperandFrame& frame, const std::vector<SurfacePointer>& operands,
                   const std::vector<PartShape>& shapes, double limit, Progress& progress) {
    constexpr double kRounding = 5e-7;  // of the size: a few steps of single precision
    if (std::none_of(shapes.begin(), shapes.end(), [](const PartShape& part) { return part.shape != nullptr; })) {
        return;
    }
    const Stopwatch fitting;
    progress.stage("fitting to the shapes", 1.0, 1.0);
    geometry::Engine& engine = shared_engine();
    std::vector<boolean::NativeOperand> native(operands.size());
    for (std::size_t i = 0; i < operands.size(); ++i) {
        native[i].mesh = frame.meshes()[i];
        native[i].faces = &operands[i]->mesh.triangle_face;
        if (shapes[i].shape != nullptr) {
            engine.run([&] { native[i].model = geometry::make_shape_model(*shapes[i].shape, &progress); }, &progress);
        }
    }
    BooleanReport& figures = surface.figures;
    const double near = figures.error_bound + kRounding * frame.size();
    const boolean::NativeFit fit =
        boolean::fit_to_native_surfaces(surface.mesh, surface.triangle_source, native, engine, near, limit, progress);
    figures.fitted_vertices = fit.moved;
    figures.unfitted_vertices = fit.reverted + fit.left;
    figures.error_bound += fit.largest_move;
    figures.seconds.emplace_back("fitting to the shapes", fitting.wall());
}

std::shared_ptr<BooleanSurface> run_boolean(const std::vector<PythonOperand>& operands, const std::string& operation,
                                            const BooleanOptions& options, const std::string& method,
                                            const Before& before, const py::object& progress) {
    options.validate();
    const Operation wanted = boolean::operation_from(operation);
    if (method != kDefault && method != kUniform) {
        throw InvalidInput("method is '" + method + "': it must be '" + kDefault + "' or '" + kUniform + "'");
    }
    std::vector<FramedOperand> framed;
    std::vector<SurfacePointer> surfaces;
    std::vector<PartShape> shapes;
    for (const auto& [surface, round, shape] : operands) {
        framed.push_back({&surface->mesh, round});
        surfaces.push_back(surface);
        shapes.push_back(shape.is_none() ? PartShape() : part_shape(shape));
    }
    return watch(progress, [&](Progress& handle) {
        const Stopwatch watch_all;
        const OperandFrame frame(framed);
        auto result = std::make_shared<BooleanSurface>();
        if (method == kUniform) {
            run_uniform(*result, frame, wanted, options, handle);
        } else {
            const double limit =
                options.tolerance > 0.0 ? options.tolerance : std::sqrt(3.0) * frame.size() / options.resolution;
            take(*result, boolean::boolean(frame.meshes(), wanted, options, &handle));
            result->figures.tolerance_asked = limit;
            fit_to_shapes(*result, frame, surfaces, shapes, limit, handle);
        }
        measure(*result, frame, wanted, before, handle);
        result->figures.cpu_seconds = before.cpu_seconds + watch_all.cpu();
        result->report = result->figures;
        return result;
    });
}

py::dict verify_surface(const Surface& surface, const py::object& progress) {
    const boolean::Verification check = watch(progress, [&](Progress& handle) {
        return boolean::verify(surface.mesh.vertices, surface.mesh.triangles, nullptr, 1000, &handle);
    });
    py::dict faults;
    for (std::size_t kind = 0; kind < boolean::kFaultKinds; ++kind) {
        faults[boolean::name(static_cast<boolean::FaultKind>(kind))] = check.count[kind];
    }
    return faults;
}

py::tuple surface_distance(const Surface& from, const Surface& to, const py::object& progress) {
    const mesh::SurfaceDistance distance =
        watch(progress, [&](Progress& handle) { return mesh::surface_distance(from.mesh, to.mesh, handle); });
    return py::make_tuple(distance.mean, distance.largest);
}

std::string to_text(const BooleanReport& report) {
    std::string text = mesh::to_text(report);
    const auto number = [](double value) {
        std::array<char, 32> buffer;
        return std::string(buffer.data(), std::snprintf(buffer.data(), buffer.size(), "%.6g", value));
    };
    text += "retained     " + std::to_string(report.retained) + " triangles of the operands, bit for bit; " +
            std::to_string(report.reconstructed) + " made or changed\n";
    text += "error bound  " + number(report.error_bound) + " mm, requested " + number(report.tolerance_asked) + " mm\n";
    if (report.fitted_vertices + report.unfitted_vertices > 0) {
        text += "on surfaces  " + std::to_string(report.fitted_vertices) + " vertices put there, " +
                std::to_string(report.unfitted_vertices) + " left on the meshes of the shapes\n";
    }
    for (const std::string& sentence : report.repaired) {
        text += "repaired     " + sentence + "\n";
    }
    return text;
}

std::string in_short(const BooleanReport& report) {
    const bool met =
        !mesh::has_faults(report) && report.error_bound <= report.tolerance_asked && report.faults_left == 0;
    std::array<char, 80> bound;
    std::snprintf(bound.data(), bound.size(), ", error bound %.3g mm of %.3g mm", report.error_bound,
                  report.tolerance_asked);
    return "<BooleanReport: " + mesh::in_short(report) + bound.data() + (met ? ">" : ", not all limits met>");
}

void bind_boolean_report(py::module_& m) {
    py::class_<BooleanReport, mesh::MeshReport>(
        m, "BooleanReport", "A MeshReport of a Boolean's result, and what happened to its operands.")
        .def_readonly("error_bound", &BooleanReport::error_bound,
                      "no point of the result is farther from the exact one of these meshes, mm")
        .def_readonly("tolerance_asked", &BooleanReport::tolerance_asked,
                      "mm; the tolerance that was requested, or that of the resolution")
        .def_readonly("retained", &BooleanReport::retained, "triangles that are an operand's own")
        .def_readonly("reconstructed", &BooleanReport::reconstructed, "all others")
        .def_readonly("repaired", &BooleanReport::repaired, "a sentence for each operand that was repaired")
        .def_readonly("faults_left", &BooleanReport::faults_left,
                      "faults of the result that no repair removed; notes name them")
        .def_readonly("crossing_pairs", &BooleanReport::crossing_pairs, "of the operands' triangles")
        .def_readonly("curve_edges", &BooleanReport::curve_edges, "edges on the intersection curves")
        .def_readonly("parted_contacts", &BooleanReport::parted_contacts, "points in which parts of the result touched")
        .def_readonly("separated_vertices", &BooleanReport::separated_vertices,
                      "vertices of surfaces that ran along each other")
        .def_readonly("fitted_vertices", &BooleanReport::fitted_vertices,
                      "made on the faces of shapes and put onto their surfaces")
        .def_readonly("unfitted_vertices", &BooleanReport::unfitted_vertices,
                      "left on the meshes of the shapes: the surfaces are too far, or a fault would result")
        .def("__repr__", &in_short)
        .def("__str__", &to_text);
}

}  // namespace

void bind_boolean(py::module_& m) {
    bind_boolean_report(m);
    py::class_<BooleanSurface, Surface, std::shared_ptr<BooleanSurface>>(m, "BooleanSurface", "A Boolean's result.")
        .def_property_readonly("triangle_source",
                               [](const py::object& self) {
                                   const auto& source = self.cast<const BooleanSurface&>().triangle_source;
                                   return view<std::int32_t>(source.data(), source.size(), 2, self);
                               })
        .def_readonly("report", &BooleanSurface::figures);
    py::class_<BooleanOptions>(m, "BooleanOptions", "Options of boolean; tolerance 0: what resolution gives.")
        .def(py::init<>())
        .def_readwrite("tolerance", &BooleanOptions::tolerance)
        .def_readwrite("resolution", &BooleanOptions::resolution);
    py::class_<Before>(m, "Before", "What was done before the core was called: stages, notes, time.")
        .def(py::init<>())
        .def_readwrite("seconds", &Before::seconds)
        .def_readwrite("notes", &Before::notes)
        .def_readwrite("cpu_seconds", &Before::cpu_seconds);
    m.def("boolean", &run_boolean, py::arg("operands"), py::arg("operation"), py::arg("options"), py::arg("method"),
          py::arg("before"), py::arg("progress") = py::none(),
          "A Boolean of [(Surface, whether it may be rounded to single precision, the Part.Shape it was made of or "
          "None), ...]; returns a BooleanSurface.");
    m.def("verify", &verify_surface, py::arg("surface"), py::arg("progress") = py::none(),
          "{kind of fault: how many} of a Surface, found exactly; contacts are counted up to 1000.");
    m.def("surface_distance", &surface_distance, py::arg("start"), py::arg("target"), py::arg("progress") = py::none(),
          "Mean and largest distance of the corners and centres of a Surface's triangles from another Surface, mm.");
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "curve/child_process.h"
#include "curve/curve.h"
#include "curve/fill.h"
#include "geometry/occt/shape_content.h"
#include "geometry/occt/shape_model.h"
#include "mesh/io.h"
#include "mesh/report.h"
#include "python/bindings.h"
#include "python/dict_of.h"
#include "python/engine.h"
#include "python/part_shape.h"
#include "python/watch.h"
#include "triangulate/triangulate.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using curve::CurvedMesh;
using curve::CurveReport;
using CurvedPointer = std::shared_ptr<CurvedMesh>;

/// How often a finer straight mesh is tried where the first cannot be filled or stays invalid.
constexpr int kFiner = 3;

/// From edges to those beside them: invalid elements mostly lie where long edges meet short ones.
constexpr double kGrowth = 1.5;

void halve(triangulate::Options& options) {
    options.chord_height *= 0.5;
    options.chord_height_relative *= 0.5;
}

/// Sizes that grow slowly come first: they cost fewer elements than a finer mesh of the whole part.
void refine_for_validity(triangulate::Options& options) {
    if (options.growth == 0.0) {
        options.growth = kGrowth;
    } else {
        halve(options);
    }
}

CurvedMesh attempt(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                   const triangulate::Options& straight, const curve::Options& options, Progress& handle) {
    const triangulate::Result mesh = triangulate::triangulate(engine, model, straight, &handle);
    CurvedMesh result = curve::curve(engine, model, mesh.mesh, options, &handle);
    result.report.self_intersections = mesh.report.self_intersections;
    result.report.crossings = mesh.report.crossings;
    return result;
}

CurvedMesh curved(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                  triangulate::Options straight, const curve::Options& options, Progress& handle) {
    std::optional<CurvedMesh> best;
    for (int times = 0;; ++times) {
        try {
            CurvedMesh mesh = attempt(engine, model, straight, options, handle);
            if (times > 0) {
                mesh.report.notes.push_back("the straight mesh was made finer " + std::to_string(times) + " times");
            }
            if (!best || mesh.report.invalid < best->report.invalid) {
                best = std::move(mesh);
            }
            refine_for_validity(straight);
        } catch (const curve::CannotFill&) {
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

CurvedPointer curve_shape(const PartShape& part, const curve::Options& options, const triangulate::Options& straight,
                          const py::object& progress) {
    options.validate();
    straight.validate();
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        const double start = curve::cpu_seconds();
        std::shared_ptr<geometry::Model> model;
        handle.stage("reading the shape", 0.0, 0.0);
        engine.run([&] { model = geometry::make_shape_model(*part.shape, &handle, geometry::Creases::Cut); }, &handle);
        auto mesh = std::make_shared<CurvedMesh>(curved(engine, model, straight, options, handle));
        engine.run([&] { mesh->report.cad_volume = geometry::solid_content(*part.shape); }, &handle);
        mesh->report.cpu_seconds = curve::cpu_seconds() - start;
        return mesh;
    });
}

CurvedPointer curve_surface(const triangulate::Result& surface, const PartShape& part, const curve::Options& options,
                            const py::object& progress) {
    options.validate();
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        std::shared_ptr<geometry::Model> model;
        const bool pieces = !surface.mesh.triangle_piece.empty();
        const geometry::Creases creases = pieces ? geometry::Creases::Cut : geometry::Creases::Keep;
        engine.run([&] { model = geometry::make_shape_model(*part.shape, &handle, creases); }, &handle);
        auto mesh = std::make_shared<CurvedMesh>(curve::curve(engine, model, surface.mesh, options, &handle));
        engine.run([&] { mesh->report.cad_volume = geometry::solid_content(*part.shape); }, &handle);
        return mesh;
    });
}

void bind_curve_report(py::module_& m) {
    const auto in_short = [](const CurveReport& r) {
        std::array<char, 120> figures;
        std::snprintf(figures.data(), figures.size(), ", shape distortion at most %.3g, max. deviation %.3g mm>",
                      r.max_shape_distortion, r.max_deviation);
        const std::string valid = r.invalid == 0 ? "all valid" : mesh::counted(r.invalid, "invalid element");
        return "<CurveReport: " + mesh::counted(r.elements, "element") + ", " + valid + figures.data();
    };
    py::class_<CurveReport>(m, "CurveReport", "What was measured on a curved mesh, and what was repaired.")
        .def_readonly("elements", &CurveReport::elements, "tetrahedra of a volume, triangles of a surface")
        .def_readonly("vertices", &CurveReport::vertices, "corner vertices")
        .def_readonly("invalid_before", &CurveReport::invalid_before, "right after curving, before any repair")
        .def_readonly("invalid", &CurveReport::invalid, "of the final mesh")
        .def_readonly("invalid_elements", &CurveReport::invalid_elements,
                      "[text, ...]: which these are, as \"triangle 3 on Face1\"")
        .def_readonly("min_scaled_jacobian", &CurveReport::min_scaled_jacobian, "min J / J of the straight element")
        .def_readonly("min_distortion", &CurveReport::min_distortion, "min J / max J")
        .def_readonly("max_shape_distortion", &CurveReport::max_shape_distortion,
                      "the largest of triangle_distortion or tetrahedron_distortion: 1 is the regular shape")
        .def_readonly("mean_distortion", &CurveReport::mean_distortion, "mean of min J / max J")
        .def_readonly("max_deviation", &CurveReport::max_deviation, "from the CAD faces, mm")
        .def_readonly("rms_deviation", &CurveReport::rms_deviation, "likewise, the root of the mean square")
        .def_readonly("straightened", &CurveReport::straightened, "[text, ...]: elements that were made straight")
        .def_readonly("volume", &CurveReport::volume, "that the curved triangles enclose, mm^3; 0 without a solid")
        .def_readonly("cad_volume", &CurveReport::cad_volume, "of the solids, mm^3; 0: unknown")
        .def_property_readonly("volume_error", &CurveReport::volume_error, "relative; -1: unknown")
        .def_readonly("moved_vertices", &CurveReport::moved_vertices, "corner vertices that a repair moved")
        .def_property_readonly(
            "repairs", [](const CurveReport& r) { return dict_of(r.repairs); }, "{kind of repair: how many}")
        .def_readonly("notes", &CurveReport::notes, "sentences about the part and the mesh that a user should know")
        .def_property_readonly(
            "seconds", [](const CurveReport& r) { return dict_of(r.seconds); }, "{stage: wall-clock seconds}")
        .def_readonly("cpu_seconds", &CurveReport::cpu_seconds, "of the operation, all threads")
        .def_readonly("self_intersections", &CurveReport::self_intersections,
                      "pairs of triangles of the straight mesh that cross; -1: not looked for")
        .def_property_readonly(
            "crossing_faces", [](const CurveReport& r) { return crossings_of(r.crossings); },
            "[(CAD face, CAD face, pairs of their triangles that cross), ...]")
        .def("__repr__", in_short)
        .def("__str__", &curve::to_text);
}

}  // namespace

void bind_curve(py::module_& m) {
    bind_curve_report(m);
    bind_curved_mesh(m);
    py::class_<curve::Options>(m, "CurveOptions", "Options of curve.")
        .def(py::init<>())
        .def_readwrite("order", &curve::Options::order)
        .def_readwrite("volume", &curve::Options::volume)
        .def_readwrite("straighten", &curve::Options::straighten)
        .def_readwrite("repair", &curve::Options::repair, "off: surfaces as they are placed, to compare with");
    m.def("curve", &curve_shape, py::arg("shape"), py::arg("options"), py::arg("straight"),
          py::arg("progress") = py::none(), "Meshes and curves a Part.Shape; returns a Curved.");
    m.def("set_fill_program", &curve::set_fill_program, py::arg("path"), "Where the program lies that fills volumes.");
    m.def("curve_surface", &curve_surface, py::arg("surface"), py::arg("shape"), py::arg("options"),
          py::arg("progress") = py::none(), "Curves a Surface that triangulate made of the Part.Shape.");
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include "curve/curve.h"
#include "mesh/quality/mesh_report.h"
#include "python/bindings.h"
#include "python/bound_fields.h"
#include "python/freecad/freecad_shape.h"
#include "python/progress_watch.h"
#include "python/shared_engine.h"
#include "workflows/curve_shape.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using curve::CurvedMesh;
using curve::CurveReport;
using CurvedPointer = std::shared_ptr<CurvedMesh>;

CurvedPointer curve_shape(const FreecadShape& part, const curve::CurveOptions& options,
                          const triangulate::TriangulateOptions& straight, const py::object& progress) {
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        auto mesh =
            std::make_shared<CurvedMesh>(workflows::curve_shape(engine, *part.shape, options, straight, handle));
        mesh->report.bridge = part.bridge;
        return mesh;
    });
}

CurvedPointer curve_surface(const triangulate::Result& surface, const FreecadShape& part,
                            const curve::CurveOptions& options, const py::object& progress) {
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        auto mesh =
            std::make_shared<CurvedMesh>(workflows::curve_surface(engine, *part.shape, surface, options, handle));
        mesh->report.bridge = part.bridge;
        return mesh;
    });
}

/// A property of the mesh that was curved.
template <typename T>
void bind_straight(py::class_<CurveReport>& report, const char* name, T mesh::MeshReport::*field, const char* said) {
    report.def_property_readonly(
        name, [field](const CurveReport& r) { return value_of(r.straight.*field); }, said);
}

void bind_curve_report(py::module_& m) {
    const auto in_short = [](const CurveReport& r) {
        std::array<char, 120> figures;
        std::snprintf(figures.data(), figures.size(), ", shape distortion at most %.3g, max. deviation %.3g mm>",
                      r.max_shape_distortion, r.max_deviation);
        const std::string valid = r.invalid == 0 ? "all valid" : mesh::counted(r.invalid, "invalid element");
        return "<CurveReport: " + mesh::counted(r.elements, "element") + ", " + valid + figures.data();
    };
    py::class_<CurveReport> report(m, "CurveReport", "What was measured on a curved mesh, and what was repaired.");
    bind_fields(report);
    bind_straight(report, "self_intersections", &mesh::MeshReport::self_intersections,
                  "pairs of triangles of the straight mesh that cross; -1: not looked for");
    bind_straight(report, "overlaps", &mesh::MeshReport::overlaps,
                  "pairs of triangles of the straight mesh that cross and are of different volumes, but for those of "
                  "bodies that only touch; -1: not looked for");
    bind_straight(report, "overlapping_bodies", &mesh::MeshReport::overlapping_bodies,
                  "[(body, body, how), ...]: see MeshReport.overlapping_bodies");
    bind_straight(
        report, "contacts", &mesh::MeshReport::contacts,
        "[(solid, solid, triangles on one side, mm^2), ...] of the straight mesh: where solids share elements; "
        "see imprint");
    bind_straight(report, "crossing_faces", &mesh::MeshReport::crossings,
                  "[(CAD face, CAD face, pairs of their triangles that cross), ...]");
    report.def_property_readonly("volume_error", &CurveReport::volume_error, "relative; -1: unknown")
        .def("__repr__", in_short)
        .def("__str__", &curve::to_text);
}

}  // namespace

void bind_curve(py::module_& m) {
    bind_curve_report(m);
    bind_curved_mesh(m);
    py::class_<curve::CurveOptions> options(m, "CurveOptions", "Options of curve.");
    options.def(py::init<>())
        .def_property(
            "size_field", nullptr,
            [](curve::CurveOptions& o, const SizeField* field) {
                o.size_field = field != nullptr ? std::make_shared<const SizeField>(*field) : nullptr;
            },
            "SizeField: bounds the lengths of edges inside; None: no field");
    bind_fields(options);
    m.def("curve", &curve_shape, py::arg("shape"), py::arg("options"), py::arg("straight"),
          py::arg("progress") = py::none(), "Meshes and curves a Part.Shape; returns a Curved.");
    m.def("curve_surface", &curve_surface, py::arg("surface"), py::arg("shape"), py::arg("options"),
          py::arg("progress") = py::none(), "Curves a Surface that triangulate made of the Part.Shape.");
}

}  // namespace mq::python

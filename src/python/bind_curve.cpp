// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include "curve/curve.h"
#include "mesh/quality/mesh_report.h"
#include "python/bindings.h"
#include "python/dict_of.h"
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
        return std::make_shared<CurvedMesh>(workflows::curve_shape(engine, *part.shape, options, straight, handle));
    });
}

CurvedPointer curve_surface(const triangulate::Result& surface, const FreecadShape& part,
                            const curve::CurveOptions& options, const py::object& progress) {
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        return std::make_shared<CurvedMesh>(workflows::curve_surface(engine, *part.shape, surface, options, handle));
    });
}

/// What crosses: curved elements, and triangles of the straight mesh.
void bind_crossings(py::class_<CurveReport>& report) {
    report
        .def_readonly("curved_intersections", &CurveReport::curved_intersections,
                      "pairs of curved triangles that are proven to cross; -1: not looked for")
        .def_readonly("curved_overlaps", &CurveReport::curved_overlaps,
                      "those of them of different bodies, which no node connects; -1: not looked for")
        .def_readonly("not_proven_apart", &CurveReport::not_proven_apart,
                      "pairs that are neither proven to cross nor to be apart, as where they touch; -1: not looked for")
        .def_property_readonly(
            "self_intersections", [](const CurveReport& r) { return r.straight.self_intersections; },
            "pairs of triangles of the straight mesh that cross; -1: not looked for")
        .def_property_readonly(
            "overlaps", [](const CurveReport& r) { return r.straight.overlaps; },
            "pairs of triangles of the straight mesh that cross and are of different volumes, but for those of bodies "
            "that only touch; -1: not looked for")
        .def_property_readonly(
            "overlapping_bodies", [](const CurveReport& r) { return overlaps_of(r.straight.overlapping_bodies); },
            "[(body, body, how), ...]: see MeshReport.overlapping_bodies")
        .def_property_readonly(
            "contacts", [](const CurveReport& r) { return contacts_of(r.straight.contacts); },
            "[(solid, solid, triangles on one side, mm^2), ...] of the straight mesh: where solids share elements; see "
            "imprint")
        .def_property_readonly(
            "crossing_faces", [](const CurveReport& r) { return crossings_of(r.straight.crossings); },
            "[(CAD face, CAD face, pairs of their triangles that cross), ...]");
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
    bind_crossings(report);
    report.def_readonly("elements", &CurveReport::elements, "tetrahedra of a volume, triangles of a surface")
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
        .def_readonly("cad_volume_error", &CurveReport::cad_volume_error,
                      "how far cad_volume may be off, mm^3: error of its integration, and of faces that meet within "
                      "the tolerance of their edges")
        .def_property_readonly("volume_error", &CurveReport::volume_error, "relative; -1: unknown")
        .def_readonly("moved_vertices", &CurveReport::moved_vertices, "corner vertices that a repair moved")
        .def_property_readonly(
            "repairs", [](const CurveReport& r) { return dict_of(r.repairs); }, "{kind of repair: how many}")
        .def_readwrite("notes", &CurveReport::notes, "sentences about the part and the mesh that a user should know")
        .def_property_readonly(
            "seconds", [](const CurveReport& r) { return dict_of(r.seconds); }, "{stage: wall-clock seconds}")
        .def_readonly("cpu_seconds", &CurveReport::cpu_seconds, "of the operation, all threads")
        .def_readonly("chord_height_asked", &CurveReport::chord_height_asked,
                      "largest deviation that was requested, mm; 0: none")
        .def_readonly("straight", &CurveReport::straight, "MeshReport of the mesh that was curved")
        .def("__repr__", in_short)
        .def("__str__", &curve::to_text);
}

}  // namespace

void bind_curve(py::module_& m) {
    bind_curve_report(m);
    bind_curved_mesh(m);
    py::class_<curve::CurveOptions>(m, "CurveOptions", "Options of curve.")
        .def(py::init<>())
        .def_readwrite("order", &curve::CurveOptions::order)
        .def_readwrite("volume", &curve::CurveOptions::volume)
        .def_readwrite("straighten", &curve::CurveOptions::straighten)
        .def_readwrite("repair", &curve::CurveOptions::repair, "off: surfaces as they are placed, to compare with")
        .def_readwrite("threads", &curve::CurveOptions::threads);
    m.def("curve", &curve_shape, py::arg("shape"), py::arg("options"), py::arg("straight"),
          py::arg("progress") = py::none(), "Meshes and curves a Part.Shape; returns a Curved.");
    m.def("curve_surface", &curve_surface, py::arg("surface"), py::arg("shape"), py::arg("options"),
          py::arg("progress") = py::none(), "Curves a Surface that triangulate made of the Part.Shape.");
}

}  // namespace mq::python

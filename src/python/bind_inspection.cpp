// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/error.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/bound_fields.h"
#include "python/freecad/freecad_shape.h"
#include "python/progress_watch.h"
#include "python/shared_engine.h"
#include "workflows/inspect_solids.h"
#include "workflows/measure_clearances.h"
#include "workflows/measure_draft.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using inspection::ThicknessOptions;
using inspection::ThicknessValues;
using workflows::ThicknessSurface;
using Surface = triangulate::Result;

static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are handed to NumPy as they lie in memory");

std::shared_ptr<ThicknessSurface> measure_thickness(const Surface& given, const ThicknessOptions& options,
                                                    const py::object& progress) {
    return watch(progress, [&](Progress& handle) {
        return std::make_shared<ThicknessSurface>(workflows::measure_thickness(given, options, handle));
    });
}

/// (value, point, opposite, is_wall), views that keep `owner` alive.
py::tuple arrays_of(const ThicknessValues& values, const py::object& owner) {
    const std::size_t count = values.value.size();
    return py::make_tuple(view<double>(values.value.data(), count, 1, owner),
                          view<double>(values.point.data(), count, 3, owner),
                          view<std::int32_t>(values.opposite.data(), count, 1, owner),
                          view<bool>(values.is_wall.data(), count, 1, owner));
}

using inspection::Clearance;
using inspection::NearestPlaces;

/// (distance, (triangle, triangle), (point, point))
py::tuple tuple_of(const NearestPlaces& places) {
    return py::make_tuple(places.distance, py::make_tuple(places.triangles[0], places.triangles[1]),
                          py::make_tuple(value_of(places.points[0]), value_of(places.points[1])));
}

std::vector<Clearance> measure_clearances(const std::vector<std::shared_ptr<Surface>>& bodies,
                                          const std::vector<double>& slack, double within, const py::object& progress) {
    if (slack.size() != bodies.size()) {
        throw InvalidInput("slack must have a length for each body");
    }
    std::vector<const Surface*> given;
    for (const std::shared_ptr<Surface>& body : bodies) {
        given.push_back(body.get());
    }
    inspection::ClearanceOptions options;
    options.within = within;
    return watch(progress,
                 [&](Progress& handle) { return workflows::measure_clearances(given, slack, options, handle); });
}

void bind_clearance(py::module_& m) {
    py::class_<Clearance>(m, "Clearance", "How near two bodies are to each other.")
        .def_property_readonly("bodies",
                               [](const Clearance& self) { return py::make_tuple(self.bodies[0], self.bodies[1]); })
        .def_property_readonly(
            "nearest", [](const Clearance& self) { return tuple_of(self.nearest); },
            "(distance in mm, (triangle, triangle), (point, point))")
        .def_readonly("depth", &Clearance::depth, "mm, of points of one in the other")
        .def_readonly("common_volume", &Clearance::common_volume, "mm^3, of what both have in common; -1: not known")
        .def_readonly("common_area", &Clearance::common_area, "mm^2, of its surface; -1: not known")
        .def_readonly("inside", &Clearance::inside, "0 | 1: which lies in the other one; -1: none")
        .def_property_readonly(
            "faces",
            [](const Clearance& self) {
                py::list faces;
                for (const NearestPlaces& places : self.faces) {
                    faces.append(tuple_of(places));
                }
                return faces;
            },
            "the same as nearest, of each pair of CAD faces that is nearly as near");
    m.def("measure_clearances", &measure_clearances, py::arg("bodies"), py::arg("slack"),
          py::arg("within") = std::numeric_limits<double>::infinity(), py::arg("progress") = py::none(),
          "[Clearance, ...] of all pairs of Surfaces that are at most `within` mm apart.");
}

using workflows::DraftSurface;

std::shared_ptr<DraftSurface> measure_draft(const Surface& given, const py::object& shape,
                                            const std::array<double, 3>& pull, double offset,
                                            const py::object& progress) {
    const FreecadShape part = shape.is_none() ? FreecadShape() : part_shape(shape);
    inspection::DraftOptions options;
    options.pull = Vec3(pull[0], pull[1], pull[2]);
    options.offset = offset;
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        return std::make_shared<DraftSurface>(
            workflows::measure_draft(engine, given, part.shape.get(), options, handle));
    });
}

/// (Surface, int32 (T,): the body of each triangle, empty where all are one)
py::tuple solid_surface(const Surface& given, const py::object& progress) {
    workflows::SolidSurface found =
        watch(progress, [&](Progress& handle) { return workflows::solid_surface(given, handle); });
    return py::make_tuple(std::make_shared<Surface>(std::move(found.surface)), array_of(found.body));
}

void bind_draft(py::module_& m) {
    py::class_<DraftSurface, std::shared_ptr<DraftSurface>>(m, "DraftSurface", "A closed surface and its draft.")
        .def_property_readonly(
            "surface", [](const DraftSurface& self) { return std::make_shared<Surface>(self.solids.surface); },
            "a copy of the Surface that was measured")
        .def_property_readonly(
            "angles",
            [](const py::object& self) {
                const auto& angle = self.cast<const DraftSurface&>().draft.angle;
                return view<double>(angle.data(), angle.size(), 1, self);
            },
            "float64 (T,), degrees")
        .def_property_readonly(
            "release",
            [](const py::object& self) {
                const auto& release = self.cast<const DraftSurface&>().draft.release;
                return view<std::int8_t>(release.data(), release.size(), 1, self);
            },
            "int8 (T,): 0 undercut, 1 along the pull, 2 against it, 3 either")
        .def_readonly("exact_normals", &DraftSurface::exact_normals, "triangles with the normal of their CAD face");
    m.def("measure_draft", &measure_draft, py::arg("surface"), py::arg("shape"), py::arg("pull"),
          py::arg("offset") = 0.0, py::arg("progress") = py::none(),
          "The DraftSurface of a Surface, with the normals of the Part.Shape unless that is None.");
    m.def("solid_surface", &solid_surface, py::arg("surface"), py::arg("progress") = py::none(),
          "(Surface, int32 (T,)): a closed surface, repaired where needed, and the body of each triangle; empty: one.");
}

}  // namespace

void bind_inspection(py::module_& m) {
    bind_clearance(m);
    bind_draft(m);
    py::class_<ThicknessOptions> options(m, "ThicknessOptions", "Options of measure_thickness; spacing 0: size / 50.");
    options.def(py::init<>());
    bind_fields(options);
    py::class_<ThicknessSurface, std::shared_ptr<ThicknessSurface>>(
        m, "ThicknessSurface", "A closed surface, and the thickness of what it bounds.")
        .def_property_readonly(
            "surface", [](const ThicknessSurface& self) { return std::make_shared<Surface>(self.solids.surface); },
            "a copy of the Surface that was measured")
        .def_property_readonly(
            "by_rays",
            [](const py::object& self) { return arrays_of(self.cast<const ThicknessSurface&>().thickness.rays, self); },
            "float64 (T,), float64 (T, 3), int32 (T,), bool (T,): value in mm, its point in the frame of the surface, "
            "the "
            "triangle opposite, whether that is a wall")
        .def_property_readonly(
            "by_spheres",
            [](const py::object& self) {
                return arrays_of(self.cast<const ThicknessSurface&>().thickness.balls, self);
            },
            "the same by inscribed spheres")
        .def_property_readonly(
            "seconds", [](const ThicknessSurface& self) { return value_of(self.seconds); },
            "{stage: wall-clock seconds}")
        .def_readonly("cpu_seconds", &ThicknessSurface::cpu_seconds, "of the operation, all threads");
    m.def("measure_thickness", &measure_thickness, py::arg("surface"), py::arg("options"),
          py::arg("progress") = py::none(),
          "The ThicknessSurface of a Surface, which is repaired where it is not closed.");
}

}  // namespace mq::python

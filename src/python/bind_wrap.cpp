// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "python/bindings.h"
#include "python/progress_watch.h"
#include "workflows/wrap_objects.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using workflows::WorkBefore;
using workflows::WrapSurface;
using Surface = triangulate::Result;
/// An object: its surface, and whether its coordinates may be rounded to single precision.
using Object = std::pair<std::shared_ptr<Surface>, bool>;

std::shared_ptr<WrapSurface> wrap_objects(const std::vector<Object>& objects, double gap, double tolerance,
                                          const std::vector<std::array<double, 3>>& dry, int threads,
                                          const WorkBefore& before, const py::object& progress) {
    std::vector<workflows::BooleanOperand> given;
    for (const auto& [surface, round] : objects) {
        given.push_back({surface.get(), round, nullptr});
    }
    wrap::WrapOptions options;
    options.gap = gap;
    options.spacing = tolerance;
    options.threads = threads;
    for (const std::array<double, 3>& place : dry) {
        options.dry.emplace_back(place[0], place[1], place[2]);
    }
    return watch(progress, [&](Progress& handle) {
        return std::make_shared<WrapSurface>(workflows::wrap_objects(given, options, before, handle));
    });
}

std::array<double, 3> coordinates(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

/// (dry place, [(x, y, z), ...] of the path, narrowest place, width there)
py::tuple tuple_of(const wrap::Leak& leak) {
    std::vector<std::array<double, 3>> path;
    std::transform(leak.path.begin(), leak.path.end(), std::back_inserter(path), coordinates);
    return py::make_tuple(coordinates(leak.dry), path, coordinates(leak.narrowest), leak.width);
}

}  // namespace

void bind_wrap(py::module_& m) {
    py::class_<WrapSurface, workflows::BooleanSurface, std::shared_ptr<WrapSurface>>(m, "WrapSurface",
                                                                                     "The wrap of some objects.")
        .def_property_readonly("distance_to_input", [](const WrapSurface& self) { return self.distance.to_input; })
        .def_property_readonly("distance_from_input", [](const WrapSurface& self) { return self.distance.from_input; })
        .def_readonly("gap_triangles", &WrapSurface::gap_triangles)
        .def_readonly("gap_area", &WrapSurface::gap_area, "mm2")
        .def_readonly("sheet_nodes", &WrapSurface::sheet_nodes)
        .def_property_readonly(
            "leaks",
            [](const WrapSurface& self) {
                py::list leaks;
                for (const wrap::Leak& leak : self.leaks) {
                    leaks.append(tuple_of(leak));
                }
                return leaks;
            },
            "[(dry place, path, narrowest place, width in mm), ...]");
    m.def("wrap_objects", &wrap_objects, py::arg("objects"), py::arg("gap"), py::arg("tolerance"), py::arg("dry"),
          py::arg("threads"), py::arg("before"), py::arg("progress") = py::none(),
          "The outer surface of objects [(Surface, round), ...] without openings narrower than the gap; lengths in mm. "
          "Returns a WrapSurface.");
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <memory>
#include <string>

#include "improve/improve.h"
#include "mesh/exemptions.h"
#include "mesh/report.h"
#include "python/bindings.h"
#include "python/stopwatch.h"
#include "python/watch.h"
#include "triangulate/triangulate.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using Surface = triangulate::Result;
using improve::Options;

std::string sentence(const improve::Result& result) {
    return "edges swapped: " + std::to_string(result.flips) + ", collapsed: " + std::to_string(result.collapses) +
           ", halved: " + std::to_string(result.splits) + "; vertices moved: " + std::to_string(result.moves);
}

std::shared_ptr<Surface> improve_surface(const Surface& given, const Options& options, const py::object& progress) {
    return watch(progress, [&](Progress& handle) {
        const Stopwatch watch_all;
        improve::Result result = improve::improve(given.mesh, options, &handle);
        auto surface = std::make_shared<Surface>();
        surface->mesh = std::move(result.mesh);
        surface->report = mesh::measure(surface->mesh, &handle);
        surface->report.min_angle_asked = options.min_angle;
        mesh::set_exempt(surface->mesh, std::move(result.exempt), surface->report);
        surface->report.notes.push_back(sentence(result));
        surface->report.seconds = std::move(result.seconds);
        surface->report.cpu_seconds = watch_all.cpu();
        return surface;
    });
}

}  // namespace

void bind_improve(py::module_& m) {
    py::class_<Options>(m, "ImproveOptions", "Options of improve; tolerance 0: a thousandth of the size.")
        .def(py::init<>())
        .def_readwrite("min_angle", &Options::min_angle)
        .def_readwrite("tolerance", &Options::tolerance)
        .def_readwrite("feature_angle", &Options::feature_angle);
    m.def("improve", &improve_surface, py::arg("surface"), py::arg("options"), py::arg("progress") = py::none(),
          "A Surface with better triangles on the surface that is given.");
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <memory>
#include <utility>

#include "python/bindings.h"
#include "python/bound_fields.h"
#include "python/progress_watch.h"
#include "workflows/improve_surface.h"
#include "workflows/simplify_surface.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using Surface = triangulate::Result;
using improve::ImproveOptions;

std::shared_ptr<Surface> improve_surface(const Surface& given, const ImproveOptions& options,
                                         const py::object& progress) {
    return watch(progress, [&](Progress& handle) {
        return std::make_shared<Surface>(workflows::improve_surface(given.mesh, options, handle));
    });
}

/// (Surface, mm: bound of the deviation)
py::tuple simplify_surface(const Surface& given, double tolerance, double feature_angle, const py::object& progress) {
    workflows::SimplifyOptions options;
    options.tolerance = tolerance;
    options.feature_angle = feature_angle;
    workflows::SimplifiedSurface found =
        watch(progress, [&](Progress& handle) { return workflows::simplify_surface(given.mesh, options, handle); });
    return py::make_tuple(std::make_shared<Surface>(std::move(found.surface)), found.deviation);
}

}  // namespace

void bind_improve(py::module_& m) {
    py::class_<ImproveOptions> bound(m, "ImproveOptions", "Options of improve; tolerance 0: a thousandth of the size.");
    bound.def(py::init<>());
    bind_fields(bound);
    m.def("improve", &improve_surface, py::arg("surface"), py::arg("options"), py::arg("progress") = py::none(),
          "A Surface with better triangles on the surface that is given.");
    m.def("simplify", &simplify_surface, py::arg("surface"), py::arg("tolerance"), py::arg("feature_angle"),
          py::arg("progress") = py::none(),
          "(Surface with fewer triangles, mm: how far it deviates at most, both ways)");
}

}  // namespace mq::python

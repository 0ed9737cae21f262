// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <memory>

#include "python/bindings.h"
#include "python/bound_fields.h"
#include "python/progress_watch.h"
#include "workflows/improve_surface.h"

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

}  // namespace

void bind_improve(py::module_& m) {
    py::class_<ImproveOptions> bound(m, "ImproveOptions", "Options of improve; tolerance 0: a thousandth of the size.");
    bound.def(py::init<>());
    bind_fields(bound);
    m.def("improve", &improve_surface, py::arg("surface"), py::arg("options"), py::arg("progress") = py::none(),
          "A Surface with better triangles on the surface that is given.");
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "base/error.h"
#include "python/bindings.h"
#include "python/progress_watch.h"
#include "workflows/offset_of_solid.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using boolean::OffsetOptions;
using workflows::BooleanSurface;
using workflows::WorkBefore;
using Surface = triangulate::Result;

std::shared_ptr<BooleanSurface> offset_surface(const BooleanSurface& solid, const Surface& operand, double distance,
                                               double tolerance, int threads, const WorkBefore& before,
                                               const py::object& progress) {
    return watch(progress, [&](Progress& handle) {
        return std::make_shared<BooleanSurface>(
            workflows::offset_of_solid(solid, operand, {distance, tolerance, threads}, before, handle));
    });
}

std::shared_ptr<BooleanSurface> thicken_walls(const BooleanSurface& solid,
                                              const py::array_t<bool, py::array::c_style | py::array::forcecast>& open,
                                              double distance, double tolerance, int threads, const WorkBefore& before,
                                              const py::object& progress) {
    if (static_cast<std::size_t>(open.size()) != solid.mesh.triangles.size()) {
        throw InvalidInput("openings are marked for " + std::to_string(open.size()) + " triangles of " +
                           std::to_string(solid.mesh.triangles.size()));
    }
    const std::vector<char> left_out(open.data(), open.data() + open.size());
    return watch(progress, [&](Progress& handle) {
        return std::make_shared<BooleanSurface>(
            workflows::thickened_walls(solid, left_out, {distance, tolerance, threads}, before, handle));
    });
}

}  // namespace

void bind_offset(py::module_& m) {
    m.def(
        "offset_surface", &offset_surface, py::arg("solid"), py::arg("operand"), py::arg("distance"),
        py::arg("tolerance"), py::arg("threads"), py::arg("before"), py::arg("progress") = py::none(),
        "The offset of a BooleanSurface that is the union of one operand, a Surface; distances in mm, inward below 0. "
        "Returns a BooleanSurface.");
    m.def(
        "thicken_walls", &thicken_walls, py::arg("solid"), py::arg("open"), py::arg("distance"), py::arg("tolerance"),
        py::arg("threads"), py::arg("before"), py::arg("progress") = py::none(),
        "All that is within a distance (mm) of the triangles of a BooleanSurface that are not marked as open. Returns "
        "a BooleanSurface.");
}

}  // namespace mq::python

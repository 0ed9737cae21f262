// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "curve/elements/check_elements.h"
#include "curve/mixed/inner_nodes.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/progress_watch.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using Rows = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

py::tuple checked(const std::string& kind, int order, const PointArray& nodes, const Rows& connectivity,
                  const py::object& progress) {
    if (connectivity.ndim() != 2) {
        throw InvalidInput("elements must be an array with the nodes of one in each row");
    }
    const curve::ElementKind of_kind = curve::element_kind(kind);
    const std::vector<Vec3> points = points_of(nodes);
    const std::vector<std::int32_t> rows(connectivity.data(), connectivity.data() + connectivity.size());
    const auto width = static_cast<int>(connectivity.shape(1));
    const curve::ElementVerdicts found = watch(progress, [&](Progress& handle) {
        handle.stage("checking elements", 0.0, 1.0);
        return curve::check_elements(of_kind, order, points, rows, width, &handle);
    });
    return py::make_tuple(array_of(found.low), array_of(found.high), array_of(found.verdict));
}

py::tuple blending(const std::string& kind, int order) {
    const curve::Blending& found = curve::Blending::of(curve::element_kind(kind), order);
    std::vector<double> weights;
    for (Eigen::Index i = 0; i < found.from.rows(); ++i) {
        for (Eigen::Index j = 0; j < found.from.cols(); ++j) {
            weights.push_back(found.from(i, j));
        }
    }
    return py::make_tuple(array_of(found.inner), array_of(weights));
}

}  // namespace

void bind_elements(py::module_& m) {
    m.def("check_elements", &checked, py::arg("kind"), py::arg("order"), py::arg("nodes"), py::arg("connectivity"),
          py::arg("progress") = py::none(),
          "(low, high, verdict) by element: proven bounds of min J / max |J|, and 0 valid, 1 folded, 2 inverted, 3 not "
          "proven. kind: triangle, quadrilateral, tetrahedron, pyramid, prism or hexahedron; nodes: float64 (N, 3); "
          "connectivity: int32 (E, n) in Gmsh's order; raises InvalidInput.");
    m.def("blending", &blending, py::arg("kind"), py::arg("order"),
          "(inner nodes, weights of all nodes at each of them): those inside of an element from those on its sides.");
}

}  // namespace mq::python

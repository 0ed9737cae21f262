// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "python/array_view.h"
#include "python/bindings.h"
#include "python/freecad/freecad_shape.h"
#include "python/progress_watch.h"
#include "python/shared_engine.h"
#include "workflows/measure_deviation.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using inspection::Align;
using inspection::Deviation;
using inspection::SignedDistance;
using Surface = triangulate::Result;

std::shared_ptr<Deviation> measure_deviation(const PointArray& points, const Surface& reference,
                                             const py::object& shape, Align align, const PointArray& from,
                                             const PointArray& to, const PointArray& fit_points,
                                             const py::object& progress) {
    const FreecadShape part = shape.is_none() ? FreecadShape() : part_shape(shape);
    inspection::DeviationOptions options;
    options.align = align;
    const std::vector<Vec3> first = points_of(from), second = points_of(to), given = points_of(points);
    for (std::size_t k = 0; k < first.size() && k < second.size(); ++k) {
        options.pairs.push_back({first[k], second[k]});
    }
    options.fit_points = points_of(fit_points);
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        return std::make_shared<Deviation>(
            workflows::measure_deviation(engine, given, reference, part.shape.get(), options, handle));
    });
}

PointArray no_points() {
    return PointArray(std::vector<py::ssize_t>{0, 3});
}

/// One member of each distance, as an array of rows.
template <typename Number, typename Value>
py::array_t<Number> column(const Deviation& deviation, py::ssize_t width, const Value& value_of) {
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(deviation.distances.size())};
    if (width > 1) {
        shape.push_back(width);
    }
    py::array_t<Number> array(shape);
    Number* out = array.mutable_data();
    for (const SignedDistance& distance : deviation.distances) {
        out = value_of(distance, out);
    }
    return array;
}

py::array_t<double> vectors(const Deviation& deviation, Vec3 SignedDistance::*member) {
    return column<double>(deviation, 3, [member](const SignedDistance& distance, double* out) {
        const Vec3& vector = distance.*member;
        return std::copy(vector.data(), vector.data() + 3, out);
    });
}

void bind_alignment(py::class_<Deviation, std::shared_ptr<Deviation>>& deviation) {
    deviation.def_property_readonly("converged", [](const Deviation& self) { return self.alignment.converged; })
        .def_property_readonly(
            "motion",
            [](const Deviation& self) {
                const geometry::RigidMotion& motion = self.alignment.motion;
                py::array_t<double> array({4, 4});
                auto at = array.mutable_unchecked<2>();
                for (int i = 0; i < 4; ++i) {
                    for (int j = 0; j < 4; ++j) {
                        at(i, j) = i == 3 ? (j == 3 ? 1.0 : 0.0) : (j == 3 ? motion.shift[i] : motion.turn(i, j));
                    }
                }
                return array;
            },
            "float64 (4, 4), of columns: where the points were measured")
        .def_property_readonly(
            "rms", [](const Deviation& self) { return self.alignment.rms; }, "mm, of the points that were fitted")
        .def_property_readonly("used", [](const Deviation& self) { return self.alignment.used; })
        .def_property_readonly("fitted", [](const Deviation& self) { return self.alignment.points; })
        .def_property_readonly("iterations", [](const Deviation& self) { return self.alignment.iterations; })
        .def_property_readonly(
            "shift_error", [](const Deviation& self) { return self.alignment.shift_error; }, "mm, standard error")
        .def_property_readonly(
            "turn_error", [](const Deviation& self) { return self.alignment.turn_error; }, "radians, standard error")
        .def_property_readonly("undetermined", [](const Deviation& self) { return self.alignment.undetermined; });
}

}  // namespace

void bind_deviation(py::module_& m) {
    py::enum_<Align>(m, "Align", "How points are aligned before they are measured.")
        .value("none", Align::None)
        .value("near", Align::Near)
        .value("any", Align::Any)
        .value("pairs", Align::Pairs)
        .value("three_two_one", Align::ThreeTwoOne);
    py::class_<Deviation, std::shared_ptr<Deviation>> deviation(m, "Deviation", "Signed distances of points.");
    deviation
        .def_property_readonly(
            "values",
            [](const Deviation& self) {
                return column<double>(self, 1, [](const SignedDistance& distance, double* out) {
                    *out = distance.value;
                    return out + 1;
                });
            },
            "float64 (N,), mm")
        .def_property_readonly(
            "faces",
            [](const Deviation& self) {
                return column<std::int32_t>(self, 1, [](const SignedDistance& distance, std::int32_t* out) {
                    *out = distance.face;
                    return out + 1;
                });
            },
            "int32 (N,): the CAD face of the nearest point; -1: none")
        .def_property_readonly(
            "nearest", [](const Deviation& self) { return vectors(self, &SignedDistance::nearest); },
            "float64 (N, 3), mm: the nearest points")
        .def_property_readonly(
            "normals", [](const Deviation& self) { return vectors(self, &SignedDistance::normal); },
            "float64 (N, 3): unit vectors along which the distance grows")
        .def_readonly("by_mesh", &Deviation::by_mesh, "points with the distance from the mesh of the shape");
    bind_alignment(deviation);
    m.def("measure_deviation", &measure_deviation, py::arg("points"), py::arg("reference"), py::arg("shape"),
          py::arg("align") = Align::None, py::arg("pairs_from") = no_points(), py::arg("pairs_to") = no_points(),
          py::arg("fit_points") = no_points(), py::arg("progress") = py::none(),
          "The Deviation of points (N, 3) from a Surface, or from the Part.Shape that it is the mesh of.");
}

}  // namespace mq::python

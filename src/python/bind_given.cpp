// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "curve/given/given_mesh.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/freecad/freecad_shape.h"
#include "python/progress_watch.h"
#include "python/shared_engine.h"
#include "workflows/curve_shape.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using Indices = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;
using CurvedPointer = std::shared_ptr<curve::CurvedMesh>;

template <std::size_t N>
std::vector<std::array<int, N>> rows_of(const Indices& array, const char* name) {
    if (array.size() % static_cast<py::ssize_t>(N) != 0) {
        throw InvalidInput(std::string(name) + " hold " + std::to_string(array.size()) + " numbers: give " +
                           std::to_string(N) + " for each");
    }
    std::vector<std::array<int, N>> rows(static_cast<std::size_t>(array.size()) / N);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = 0; k < N; ++k) {
            rows[i][k] = array.data()[N * i + k];
        }
    }
    return rows;
}

CurvedPointer curve_given(const PointArray& nodes, const Indices& triangles, const Indices& tetrahedra,
                          const Indices& regions, const PartShape& part, const curve::CurveOptions& options,
                          bool imprint, const py::object& progress) {
    curve::GivenMesh given;
    given.nodes = points_of(nodes);
    given.triangles = rows_of<3>(triangles, "triangles");
    given.tetrahedra = rows_of<4>(tetrahedra, "tetrahedra");
    given.regions.assign(regions.data(), regions.data() + regions.size());
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        return std::make_shared<curve::CurvedMesh>(
            workflows::curve_given_mesh(engine, *part.shape, given, options, imprint, handle));
    });
}

py::tuple measure_given_surface(const PointArray& nodes, int order, const Indices& triangles, const PartShape& part,
                                const py::object& progress) {
    const std::vector<Vec3> points = points_of(nodes);
    const std::vector<std::int32_t> rows(triangles.data(), triangles.data() + triangles.size());
    geometry::Engine& engine = shared_engine();
    const curve::GivenSurfaceMeasures found = watch(progress, [&](Progress& handle) {
        return workflows::measure_given_surface(engine, *part.shape, points, order, rows, handle);
    });
    return py::make_tuple(array_of(found.face), array_of(found.quality), array_of(found.deviation));
}

py::tuple cad_distances(const PointArray& nodes, int order, const Indices& triangles, const PartShape& part,
                        const py::object& progress) {
    const std::vector<Vec3> points = points_of(nodes);
    const std::vector<std::int32_t> rows(triangles.data(), triangles.data() + triangles.size());
    geometry::Engine& engine = shared_engine();
    const curve::CadDistances found = watch(progress, [&](Progress& handle) {
        handle.stage("measuring the distance from the shape to the mesh", 0.0, 1.0);
        return workflows::cad_distances(engine, *part.shape, points, order, rows, handle);
    });
    const Vec3& p = found.farthest;
    return py::make_tuple(array_of(found.of_face), std::array<double, 3>{p.x(), p.y(), p.z()}, found.spacing,
                          found.samples);
}

py::array distances_to_faces(const PartShape& part, const PointArray& points, const py::object& progress) {
    const std::vector<Vec3> places = points_of(points);
    geometry::Engine& engine = shared_engine();
    return array_of(watch(progress, [&](Progress& handle) {
        return workflows::distances_to_faces(engine, *part.shape, places, handle);
    }));
}

}  // namespace

void bind_given(py::module_& m) {
    m.def("curve_given", &curve_given, py::arg("nodes"), py::arg("triangles"), py::arg("tetrahedra"),
          py::arg("regions"), py::arg("shape"), py::arg("options"), py::arg("imprint"),
          py::arg("progress") = py::none(),
          "Curves the corners of a mesh that another program made of the Part.Shape.");
    m.def("measure_given_surface", &measure_given_surface, py::arg("nodes"), py::arg("order"), py::arg("triangles"),
          py::arg("shape"), py::arg("progress") = py::none(),
          "(face, quality, deviation) by triangle of a surface that another program made of the Part.Shape.");
    m.def("cad_distances", &cad_distances, py::arg("nodes"), py::arg("order"), py::arg("triangles"), py::arg("shape"),
          py::arg("progress") = py::none(),
          "(distance by CAD face, farthest point, spacing of the samples, their number) from the Part.Shape to a "
          "surface.");
    m.def("distances_to_faces", &distances_to_faces, py::arg("shape"), py::arg("points"),
          py::arg("progress") = py::none(),
          "float64 (N,): distances of points from the faces of the Part.Shape, without any of its mesh.");
}

}  // namespace mq::python

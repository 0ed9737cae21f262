// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "base/error.h"
#include "given/matching/given_mesh.h"
#include "given/mixed/curve_mixed.h"
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
                          const Indices& regions, const FreecadShape& part, const curve::CurveOptions& options,
                          bool imprint, const py::object& progress) {
    curve::GivenMesh given;
    given.nodes = points_of(nodes);
    given.triangles = rows_of<3>(triangles, "triangles");
    given.tetrahedra = rows_of<4>(tetrahedra, "tetrahedra");
    given.regions.assign(regions.data(), regions.data() + regions.size());
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        auto mesh = std::make_shared<curve::CurvedMesh>(
            workflows::curve_given_mesh(engine, *part.shape, given, options, imprint, handle));
        mesh->report.bridge = part.bridge;
        return mesh;
    });
}

/// Elements of one kind as Python has them: its name, their corners, and a number that differs between bodies for each.
using CornerBlock = std::tuple<std::string, Indices, Indices>;

void add_elements(const std::vector<CornerBlock>& blocks, std::vector<curve::MixedElement>& elements) {
    for (const auto& [name, corners, regions] : blocks) {
        curve::MixedElement element;
        element.kind = curve::element_kind(name);
        const auto width = static_cast<py::ssize_t>(element.count());
        if (corners.size() != width * regions.size()) {
            throw InvalidInput(name + "s hold " + std::to_string(corners.size()) + " corners: give " +
                               std::to_string(width) + " for each");
        }
        for (py::ssize_t i = 0; i < regions.size(); ++i) {
            std::copy_n(corners.data() + i * width, width, element.corners.begin());
            element.region = regions.data()[i];
            elements.push_back(element);
        }
    }
}

py::dict curve_mixed(const PointArray& nodes, const std::vector<CornerBlock>& elements,
                     const std::vector<CornerBlock>& listed, const FreecadShape& part,
                     const curve::CurveOptions& options, bool imprint, const py::object& progress) {
    curve::MixedMesh given;
    given.nodes = points_of(nodes);
    add_elements(elements, given.elements);
    add_elements(listed, given.listed);
    geometry::Engine& engine = shared_engine();
    curve::CurvedMixedMesh mesh = watch(progress, [&](Progress& handle) {
        return workflows::curve_mixed_mesh(engine, *part.shape, given, options, imprint, handle);
    });
    mesh.report.bridge = part.bridge;
    py::list blocks;
    for (const curve::ElementBlock& block : mesh.blocks) {
        blocks.append(py::make_tuple(curve::name_of(block.kind), array_of(block.nodes), array_of(block.entity),
                                     array_of(block.quality), array_of(block.given)));
    }
    std::vector<double> coordinates;
    for (const Vec3& p : mesh.nodes) {
        coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
    }
    py::dict result;
    result["nodes"] = array_of(coordinates);
    result["blocks"] = blocks;
    result["edges"] = array_of(mesh.edges);
    result["edge_entity"] = array_of(mesh.edge_entity);
    result["given_node"] = array_of(mesh.given_node);
    result["moved_nodes"] = array_of(mesh.moved_nodes);
    result["report"] = mesh.report;
    return result;
}

py::tuple measure_given_surface(const PointArray& nodes, int order, const Indices& triangles, const FreecadShape& part,
                                const py::object& progress) {
    const std::vector<Vec3> points = points_of(nodes);
    const std::vector<std::int32_t> rows(triangles.data(), triangles.data() + triangles.size());
    geometry::Engine& engine = shared_engine();
    const curve::GivenSurfaceMeasures found = watch(progress, [&](Progress& handle) {
        return workflows::measure_given_surface(engine, *part.shape, points, order, rows, handle);
    });
    return py::make_tuple(array_of(found.face), array_of(found.quality), array_of(found.deviation));
}

py::tuple cad_distances(const PointArray& nodes, int order, const Indices& triangles, const FreecadShape& part,
                        const py::object& progress) {
    const std::vector<Vec3> points = points_of(nodes);
    const std::vector<std::int32_t> rows(triangles.data(), triangles.data() + triangles.size());
    geometry::Engine& engine = shared_engine();
    const curve::CadDistances found = watch(progress, [&](Progress& handle) {
        handle.stage("measuring the distance from the shape to the mesh", 0.0, 1.0);
        return workflows::cad_distances(engine, *part.shape, points, order, rows, handle);
    });
    const Vec3& p = found.farthest;
    py::list faces;
    for (const curve::CadDistances::FaceGrid& grid : found.face_grids) {
        faces.append(
            py::make_tuple(grid.face, grid.low[0], grid.high[0], grid.low[1], grid.high[1], grid.columns, grid.rows));
    }
    py::list edges;
    for (const curve::CadDistances::EdgeGrid& grid : found.edge_grids) {
        edges.append(py::make_tuple(grid.edge, grid.low, grid.high, grid.steps));
    }
    return py::make_tuple(array_of(found.of_face), std::array<double, 3>{p.x(), p.y(), p.z()}, found.spacing, faces,
                          edges);
}

py::array distances_to_faces(const FreecadShape& part, const PointArray& points, const py::object& progress) {
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
    m.def(
        "curve_mixed", &curve_mixed, py::arg("nodes"), py::arg("elements"), py::arg("listed"), py::arg("shape"),
        py::arg("options"), py::arg("imprint"), py::arg("progress") = py::none(),
        "Curves elements of any kinds, which another program made of the Part.Shape: lists of (kind, corners, bodies), "
        "solids or else the surface, and beside solids what the mesh lists of surfaces. A dictionary with nodes, "
        "blocks "
        "of (kind, nodes, entity, quality, given element), edges, given_node, moved_nodes and report.");
    m.def("measure_given_surface", &measure_given_surface, py::arg("nodes"), py::arg("order"), py::arg("triangles"),
          py::arg("shape"), py::arg("progress") = py::none(),
          "(face, quality, deviation) by triangle of a surface that another program made of the Part.Shape.");
    m.def("cad_distances", &cad_distances, py::arg("nodes"), py::arg("order"), py::arg("triangles"), py::arg("shape"),
          py::arg("progress") = py::none(),
          "(distance by CAD face, farthest point, spacing of the samples, [(face, u0, u1, v0, v1, columns, rows)], "
          "[(edge, t0, t1, steps)] of their grids) from the Part.Shape to a surface.");
    m.def("distances_to_faces", &distances_to_faces, py::arg("shape"), py::arg("points"),
          py::arg("progress") = py::none(),
          "float64 (N,): distances of points from the faces of the Part.Shape, without any of its mesh.");
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/injectivity/common_points.h"
#include "curve/injectivity/curved_crossings.h"
#include "elements/product/check_elements.h"
#include "given/mixed/transfinite_blending.h"
#include "mesh/io/io.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/progress_watch.h"
#include "python/python_lock.h"
#include "tetrahedralise/tetrahedralise.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using Rows = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

py::tuple checked(const std::string& kind, int order, const PointArray& nodes, const Rows& connectivity,
                  const py::object& progress) {
    if (connectivity.ndim() != 2) {
        throw InvalidInput(phrases::kElementRows);
    }
    const elements::ElementKind of_kind = elements::element_kind(kind);
    const std::vector<Vec3> points = points_of(nodes);
    const std::vector<std::int32_t> rows(connectivity.data(), connectivity.data() + connectivity.size());
    const auto width = static_cast<int>(connectivity.shape(1));
    const elements::ElementVerdicts found = watch(progress, [&](Progress& handle) {
        handle.stage("checking elements", 0.0, 1.0);
        return elements::check_elements(of_kind, order, points, rows, width, &handle);
    });
    return py::make_tuple(array_of(found.low), array_of(found.high), array_of(found.verdict));
}

py::tuple blending(const std::string& kind, int order) {
    const given::Blending& found = given::Blending::of(elements::element_kind(kind), order);
    std::vector<double> weights;
    for (Eigen::Index i = 0; i < found.from.rows(); ++i) {
        for (Eigen::Index j = 0; j < found.from.cols(); ++j) {
            weights.push_back(found.from(i, j));
        }
    }
    return py::make_tuple(array_of(found.inner), array_of(weights));
}

using SideRows = std::vector<std::tuple<std::string, int, Rows>>;
using PairList = std::vector<std::pair<std::int32_t, std::int32_t>>;

std::vector<std::int32_t> flat(const Rows& rows) {
    if (rows.ndim() != 2) {
        throw InvalidInput(phrases::kElementRows);
    }
    return {rows.data(), rows.data() + rows.size()};
}

/// The pairs that are proven to cross, those that are not proven to be apart, those that touch, and how many were given
/// up.
std::tuple<PairList, PairList, PairList, std::size_t> crossings(const PointArray& nodes, const SideRows& sides,
                                                                const py::object& progress) {
    const std::vector<Vec3> points = points_of(nodes);
    std::vector<curve::SideBlock> blocks;
    for (const auto& [kind, order, rows] : sides) {
        blocks.push_back({elements::element_kind(kind), order, static_cast<int>(rows.shape(1)), flat(rows)});
    }
    curve::CurvedCrossings found = watch(progress, [&](Progress& handle) {
        handle.stage("comparing curved triangles", 0.0, 1.0);
        return curve::curved_crossings(curve::SurfacePatches(points, blocks), &handle);
    });
    PairList crossing;
    for (const curve::CurvedCrossings::Crossing& pair : found.crossing) {
        crossing.emplace_back(pair.a, pair.b);
    }
    return {std::move(crossing), std::move(found.not_proven), std::move(found.touching), found.given_up};
}

using Solids = std::vector<std::tuple<std::string, int, Rows, std::vector<std::tuple<std::string, int, Rows>>>>;

std::vector<std::tuple<std::int32_t, std::int32_t, std::array<double, 3>>> common_points(const PointArray& nodes,
                                                                                         const Solids& solids,
                                                                                         const Rows& body,
                                                                                         const py::object& progress) {
    const std::vector<Vec3> points = points_of(nodes);
    const std::vector<std::int32_t> bodies(body.data(), body.data() + body.size());
    std::vector<curve::SolidBlock> blocks;
    for (const auto& [kind, order, rows, faces] : solids) {
        curve::SolidBlock block{elements::element_kind(kind), order, static_cast<int>(rows.shape(1)), flat(rows), {}};
        for (const auto& [face_kind, face_order, local] : faces) {
            block.faces.push_back({elements::element_kind(face_kind), face_order, flat(local)});
        }
        blocks.push_back(std::move(block));
    }
    const std::vector<curve::CommonPoint> found = watch(progress, [&](Progress& handle) {
        handle.stage("checking elements", 0.0, 1.0);
        return curve::common_points(points, blocks, bodies, &handle);
    });
    std::vector<std::tuple<std::int32_t, std::int32_t, std::array<double, 3>>> listed;
    for (const curve::CommonPoint& common : found) {
        listed.push_back(
            {common.elements[0], common.elements[1], {common.point.x(), common.point.y(), common.point.z()}});
    }
    return listed;
}

/// {format: (below, {(kind, nodes of an element)})}
py::dict element_formats() {
    py::dict found;
    for (const mesh::ElementFormat& format : mesh::element_formats()) {
        py::set types;
        for (const mesh::ElementType* type : format.types) {
            types.add(py::make_tuple(std::string(type->kind), type->nodes));
        }
        found[py::str(format.name)] = py::make_tuple(format.below, types);
    }
    return found;
}

using Blocks = std::vector<std::tuple<std::string, Rows, Rows, std::vector<std::size_t>>>;
using Groups = std::vector<std::pair<std::string, std::vector<std::pair<std::size_t, Rows>>>>;

void write_elements(const std::string& path, const std::string& format, const PointArray& nodes, const Blocks& blocks,
                    const Groups& groups, double scale) {
    mesh::ExportMesh made;
    made.scale = scale;
    made.nodes = points_of(nodes);
    for (const auto& [kind, rows, entity, lagrange] : blocks) {
        mesh::Elements& elements = made.blocks.emplace_back();
        elements.nodes = flat(rows);
        elements.type = &mesh::element_type(kind, static_cast<std::size_t>(rows.shape(1)));
        elements.entity.assign(entity.data(), entity.data() + entity.size());
        elements.lagrange = lagrange;
    }
    std::vector<mesh::NamedRows> named;
    for (const auto& [name, parts] : groups) {
        mesh::NamedRows& group = named.emplace_back(name, mesh::NamedRows::second_type());
        for (const auto& [block, rows] : parts) {
            group.second.emplace_back(block, std::vector<std::int32_t>(rows.data(), rows.data() + rows.size()));
        }
    }
    const FreedLock free;
    mesh::set_groups(made, named);
    mesh::write(made, path, format);
}

/// Tetrahedra inside a closed surface, whose points and triangles stay.
py::tuple fill_surface(const PointArray& points, const Rows& triangles, double grading, const py::object& progress) {
    const std::vector<Vec3> corners = points_of(points);
    const std::vector<std::int32_t> rows = flat(triangles);
    if (triangles.shape(1) != 3) {
        throw InvalidInput(phrases::kElementRows);
    }
    std::vector<std::array<int, 3>> surface(rows.size() / 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        surface[i / 3][i % 3] = rows[i];
    }
    const tetrahedralise::Tetrahedra found = watch(progress, [&](Progress& handle) {
        handle.stage("filling", 0.0, 1.0);
        return tetrahedralise::tetrahedralise(corners, surface, {grading, nullptr}, handle);
    });
    std::vector<double> inner;
    for (const Vec3& p : found.inner_points) {
        inner.insert(inner.end(), {p.x(), p.y(), p.z()});
    }
    std::vector<std::int32_t> tetrahedra;
    for (const std::array<int, 4>& t : found.tetrahedra) {
        tetrahedra.insert(tetrahedra.end(), t.begin(), t.end());
    }
    return py::make_tuple(array_of(inner), array_of(tetrahedra));
}

}  // namespace

void bind_elements(py::module_& m) {
    m.def("check_elements", &checked, py::arg("kind"), py::arg("order"), py::arg("nodes"), py::arg("connectivity"),
          py::arg("progress") = py::none(),
          "(low, high, verdict) by element: proven bounds of min J / max |J|, and 0 valid, 1 folded, 2 inverted, 3 not "
          "proven. kind: triangle, quadrilateral, tetrahedron, pyramid, prism or hexahedron; nodes: float64 (N, 3); "
          "connectivity: int32 (E, n) in Gmsh's order; raises InvalidInput.");
    m.def("element_formats", &element_formats,
          "{format: (below, {(kind, nodes of an element)})}: what formats hold, and how much lower the dimensions of "
          "elements in them may be than the highest one; those of lower ones are left out.");
    m.def("write_elements", &write_elements, py::arg("path"), py::arg("format"), py::arg("nodes"), py::arg("blocks"),
          py::arg("groups"), py::arg("scale"),
          "Writes a file of a format of element_formats. nodes: float64 (N, 3); blocks: [(kind, int32 (E, n) in Gmsh's "
          "order, int32 (E,) the CAD entity of each or -1, by place in VTK's Lagrange cells the place in Gmsh's "
          "order)]; groups: [(name, [(block, int32 elements)])]; raises IoError.");
    m.def(
        "fill_surface", &fill_surface, py::arg("points"), py::arg("triangles"), py::arg("grading"),
        py::arg("progress") = py::none(),
        "(inner points, tetrahedra), flat arrays: fills the inside of a closed surface, whose points and triangles "
        "stay; inner points are numbered after its own. points: float64 (N, 3), mm; triangles: int32 (T, 3), outward; "
        "grading: factor of the usual growth of edges, above 0; raises GeometryError where the surface is not closed "
        "or "
        "intersects itself.");
    m.def("blending", &blending, py::arg("kind"), py::arg("order"),
          "(inner nodes, weights of all nodes at each of them): those inside of an element from those on its sides.");
    m.def(
        "surface_crossings", &crossings, py::arg("nodes"), py::arg("sides"), py::arg("progress") = py::none(),
        "Pairs of triangles and quadrilaterals that cross, those not proven to be apart, those that only touch, and "
        "how many of the second were not compared to the end; (i, i): a side that meets itself. sides: [(kind, order, "
        "int32 (F, n) in Gmsh's order)], numbered from one to the next.");
    m.def("common_points", &common_points, py::arg("nodes"), py::arg("solids"), py::arg("body"),
          py::arg("progress") = py::none(),
          "[(element, element, point)]: for two bodies that overlap a point inside of both. solids: [(kind, int32 (E, "
          "n), "
          "[(kind of a face, order, int32 (1, m) nodes of an element)])]; body: by element.");
}

}  // namespace mq::python
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "curve/output/curved_mesh.h"
#include "curve/output/shape_distortion.h"
#include "curve/output/tessellation.h"
#include "mesh/io/io.h"
#include "mesh/quality/mesh_report.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/patches_of.h"
#include "python/progress_watch.h"
#include "python/python_lock.h"
#include "triangulate/triangulate.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using curve::CurvedMesh;
using curve::Tessellation;
using CurvedPointer = std::shared_ptr<CurvedMesh>;
using List = std::vector<std::int32_t>;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

template <typename Owner>
using Width = int (Owner::*)() const;

/// A list of rows of one length as a read-only array.
template <typename Owner, typename T>
void bind_list(py::class_<Owner, std::shared_ptr<Owner>>& cls, const char* name, std::vector<T> Owner::*list,
               Width<Owner> width = nullptr, const char* doc = "") {
    cls.def_property_readonly(
        name,
        [list, width](const py::object& self) {
            const Owner& owner = self.cast<const Owner&>();
            const auto columns = static_cast<std::size_t>(width != nullptr ? (owner.*width)() : 1);
            return view<T>((owner.*list).data(), (owner.*list).size() / columns, columns, self);
        },
        doc);
}

template <typename T>
std::vector<T> list_of(const py::array_t<T, py::array::c_style | py::array::forcecast>& array) {
    return {array.data(), array.data() + array.size()};
}

/// A mesh that was taken apart into its arrays before; its report stays empty.
/// @param arrays the properties of Curved by their names.
CurvedPointer from_arrays(int order, const py::dict& arrays) {
    auto mesh = std::make_shared<CurvedMesh>();
    mesh->order = order;
    const auto indices = [&](const char* name) { return list_of<std::int32_t>(arrays[name].cast<Indices>()); };
    const auto numbers = [&](const char* name) { return list_of<double>(arrays[name].cast<Numbers>()); };
    const std::vector<double> nodes = numbers("nodes");
    for (std::size_t i = 0; i + 2 < nodes.size(); i += 3) {
        mesh->nodes.emplace_back(nodes[i], nodes[i + 1], nodes[i + 2]);
    }
    const List entities = indices("node_entity");
    for (std::size_t i = 0; i + 1 < entities.size(); i += 2) {
        mesh->node_entity.push_back({entities[i], entities[i + 1]});
    }
    mesh->edges = indices("edges");
    mesh->edge_entity = indices("edge_entity");
    mesh->triangles = indices("triangles");
    mesh->triangle_face = indices("triangle_face");
    mesh->triangle_face_behind = indices("triangle_face_behind");
    mesh->tetrahedra = indices("tetrahedra");
    mesh->tetrahedron_volume = indices("tetrahedron_solid");
    mesh->triangle_quality = numbers("triangle_quality");
    mesh->tetrahedron_quality = numbers("tetrahedron_quality");
    curve::require_sound(*mesh);
    return mesh;
}

std::shared_ptr<Tessellation> tessellated(const CurvedMesh& mesh, double deviation, const py::object& progress) {
    return watch(progress, [&](Progress& handle) {
        handle.stage("cutting into triangles", 0.0, 1.0);
        return std::make_shared<Tessellation>(curve::tessellate(mesh, deviation, &handle));
    });
}

using Distortions = std::vector<double> (*)(const CurvedMesh&, Progress*);

template <Distortions distortions>
py::array_t<double> measured_distortions(const CurvedMesh& mesh, const py::object& progress) {
    const std::vector<double> found = watch(progress, [&](Progress& handle) {
        handle.stage("measuring the distortion", 0.0, 1.0);
        return distortions(mesh, &handle);
    });
    return py::array_t<double>(static_cast<py::ssize_t>(found.size()), found.data());
}

std::shared_ptr<triangulate::Result> surface_of(const Tessellation& tessellation) {
    auto surface = std::make_shared<triangulate::Result>();
    surface->mesh = tessellation.mesh;
    surface->report = mesh::measure(surface->mesh);
    return surface;
}

/// The straight mesh before curving, as triangulate returned it; null where that is not known.
std::shared_ptr<triangulate::Result> straight_of(const CurvedMesh& mesh) {
    if (mesh.straight.triangles.empty()) {
        return nullptr;
    }
    return std::make_shared<triangulate::Result>(triangulate::Result{mesh.straight, mesh.report.straight});
}

void write(const CurvedMesh& mesh, const std::string& path, const std::string& format, const Names& names,
           const Colours& colours, const Indices& patch, bool given, double scale, const Names& solids) {
    const mesh::Patches patches = patches_of(names, colours, patch, given);
    const FreedLock free;
    mesh::ExportMesh made = curve::exported(mesh, patches, scale);
    for (std::size_t i = 0; i < std::min(solids.size(), made.groups[3].size()); ++i) {
        made.groups[3][i].name = solids[i];
    }
    mesh::write(made, path, format);
}

void bind_tessellation(py::module_& m) {
    py::class_<Tessellation, std::shared_ptr<Tessellation>> cls(m, "Tessellation", "Flat triangles of curved ones.");
    bind_list(cls, "element", &Tessellation::element, Width<Tessellation>(),
              "by triangle: the curved triangle it is a part of");
    bind_list(cls, "edge_lines", &Tessellation::edge_lines, Width<Tessellation>(),
              "runs of vertices, each followed by -1");
    bind_list(cls, "triangle_normals", &Tessellation::triangle_normals, Width<Tessellation>(),
              "three indices of normals a triangle");
    cls.def_property_readonly("normals", [](const py::object& self) {
        const auto& normals = self.cast<const Tessellation&>().normals;
        return view<double>(normals.data(), normals.size(), 3, self);
    });
    cls.def_readonly("deviation", &Tessellation::deviation, "mm");
    cls.def("surface", &surface_of, "A Surface of the triangles.", py::call_guard<FreedLock>());
}

}  // namespace

void bind_curved_mesh(py::module_& m) {
    bind_tessellation(m);
    py::class_<CurvedMesh, CurvedPointer> cls(m, "Curved", "A curved mesh in the core's memory, and its report.");
    cls.def_readonly("order", &CurvedMesh::order);
    cls.def_property_readonly("nodes", [](const py::object& self) {
        const auto& nodes = self.cast<const CurvedMesh&>().nodes;
        return view<double>(nodes.data(), nodes.size(), 3, self);
    });
    cls.def_property_readonly("node_entity", [](const py::object& self) {
        const auto& entities = self.cast<const CurvedMesh&>().node_entity;
        return view<std::int32_t>(entities.data(), entities.size(), 2, self);
    });
    bind_list(cls, "edges", &CurvedMesh::edges, &CurvedMesh::nodes_per_edge);
    bind_list(cls, "edge_entity", &CurvedMesh::edge_entity);
    bind_list(cls, "triangles", &CurvedMesh::triangles, &CurvedMesh::nodes_per_triangle);
    bind_list(cls, "triangle_face", &CurvedMesh::triangle_face);
    bind_list(cls, "triangle_face_behind", &CurvedMesh::triangle_face_behind);
    bind_list(cls, "triangle_quality", &CurvedMesh::triangle_quality);
    bind_list(cls, "given_node", &CurvedMesh::given_node);
    bind_list(cls, "given_element", &CurvedMesh::given_element);
    bind_list(cls, "moved_nodes", &CurvedMesh::moved_nodes);
    bind_list(cls, "tetrahedra", &CurvedMesh::tetrahedra, &CurvedMesh::nodes_per_tetrahedron);
    bind_list(cls, "tetrahedron_solid", &CurvedMesh::tetrahedron_volume);
    bind_list(cls, "tetrahedron_quality", &CurvedMesh::tetrahedron_quality);
    cls.def_readonly("report", &CurvedMesh::report);
    cls.def_property_readonly("straight", &straight_of, "A Surface, the mesh that was curved; None: not known.");
    cls.def(
        "tetrahedra_behind",
        [](const CurvedMesh& mesh) {
            const List behind = curve::tetrahedra_behind(mesh);
            return py::array_t<std::int32_t>(static_cast<py::ssize_t>(behind.size()), behind.data());
        },
        "By triangle: the tetrahedron that it is a face of, or -1.");
    cls.def("triangle_distortions", &measured_distortions<curve::triangle_distortions>,
            py::arg("progress") = py::none(), "float64 (T,): upper bounds of the largest distortion, 1 is best.");
    cls.def("tetrahedron_distortions", &measured_distortions<curve::tetrahedron_distortions>,
            py::arg("progress") = py::none(), "float64 (E,): likewise.");
    cls.def("tessellate", &tessellated, py::arg("deviation"), py::arg("progress") = py::none());
    cls.def("write", &write, py::arg("path"), py::arg("format"), py::arg("names"), py::arg("colours"), py::arg("patch"),
            py::arg("given"), py::arg("scale"), py::arg("solids"),
            "As Surface.write; `solids` are the names of the solids that have elements, ascending.");
    m.def("curved_from_arrays", &from_arrays, py::arg("order"), py::arg("arrays"),
          "A Curved of the arrays that one has, by their names; raises InvalidInput.");
}

}  // namespace mq::python

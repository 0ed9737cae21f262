// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/io/io.h"
#include "mesh/quality/exemptions.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/quality/triangle_quality.h"
#include "mesh/vertex_clustering.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/bound_fields.h"
#include "python/patches_of.h"
#include "python/python_lock.h"
#include "triangulate/triangulate.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using mesh::MeshReport;
using mesh::TriangleMesh;
using Surface = triangulate::Result;
using SurfacePointer = std::shared_ptr<Surface>;

static_assert(sizeof(Vec3) == 3 * sizeof(double), "vertices are handed to NumPy as they lie in memory");

/// Any mesh given as arrays; the origin stays zero. Checks the indices and sizes, and measures the mesh unless the
/// caller does not need its report.
SurfacePointer surface_from_arrays(
    const py::array_t<double, py::array::c_style | py::array::forcecast>& vertices,
    const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>& triangles,
    const py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>& faces, bool measured) {
    const auto rows = [](const py::array& array, const char* name) {
        if (array.size() != 0 && (array.ndim() != 2 || array.shape(1) != 3)) {
            throw InvalidInput(phrases::kColumns, {{"name", name}, {"count", 3}});
        }
        return static_cast<std::size_t>(array.size() / 3);
    };
    auto surface = std::make_shared<Surface>();
    TriangleMesh& mesh = surface->mesh;
    mesh.vertices.resize(rows(vertices, "vertices"));
    mesh.triangles.resize(rows(triangles, "triangles"));
    const FreedLock free;
    const auto count = static_cast<std::int64_t>(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        std::copy_n(vertices.data() + 3 * v, 3, mesh.vertices[v].data());
    }
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        for (int i = 0; i < 3; ++i) {
            const std::int64_t v = triangles.data()[3 * k + i];
            if (v < 0 || v >= count) {
                throw InvalidInput(phrases::kNoSuchVertex, {{"count", k}, {"count2", v}, {"count3", count}});
            }
            mesh.triangles[k][i] = static_cast<std::int32_t>(v);
        }
    }
    mesh.triangle_face.assign(faces.data(), faces.data() + faces.size());
    if (measured) {
        surface->report = mesh::measure(mesh);
    }
    return surface;
}

void write_surface(const Surface& surface, const std::string& path, const std::string& format, const Names& names,
                   const Colours& colours, const Indices& patch, bool given, double scale, bool ascii) {
    const mesh::Patches patches = patches_of(names, colours, patch, given);
    const FreedLock free;
    mesh::write(mesh::exported(surface.mesh, patches, scale), path, format, ascii);
}

/// float64 (T,) each: smallest angles in degrees, longest edges / shortest edges, and distortions.
py::tuple triangle_shapes(const Surface& surface) {
    const TriangleMesh& mesh = surface.mesh;
    const auto count = static_cast<py::ssize_t>(mesh.triangles.size());
    py::array_t<double> angles(count), aspects(count), distortions(count);
    double* angle = angles.mutable_data();
    double* aspect = aspects.mutable_data();
    double* distortion = distortions.mutable_data();
    {
        const FreedLock free;
        for (const mesh::Triangle& t : mesh.triangles) {
            const mesh::TriangleShape shape =
                mesh::shape_of({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
            *angle++ = shape.min_angle;
            *aspect++ = shape.aspect;
            *distortion++ = shape.distortion;
        }
    }
    return py::make_tuple(angles, aspects, distortions);
}

/// (int64 (n,), float64 (n,)): numbers of triangles, and the smallest angle with each in degrees.
py::tuple angle_history(const Surface& surface) {
    const auto count = static_cast<py::ssize_t>(surface.angle_history.size());
    py::array_t<std::int64_t> triangles(count);
    py::array_t<double> angles(count);
    for (py::ssize_t i = 0; i < count; ++i) {
        triangles.mutable_at(i) = static_cast<std::int64_t>(surface.angle_history[i].triangles);
        angles.mutable_at(i) = surface.angle_history[i].min_angle;
    }
    return py::make_tuple(triangles, angles);
}

/// (float32 (n, 3, 3), int32 (T,)): the coarse triangles, and for each fine triangle the coarse one that represents it,
/// or -1.
py::tuple clustered(const py::array_t<float, py::array::c_style | py::array::forcecast>& corners, std::size_t wanted) {
    mesh::ClusteredMesh found;
    {
        const FreedLock free;
        found = mesh::cluster(corners.data(), static_cast<std::size_t>(corners.size() / 9), wanted);
    }
    const auto count = static_cast<py::ssize_t>(found.corners.size() / 9);
    const std::array<py::ssize_t, 3> shape{count, 3, 3};
    return py::make_tuple(
        py::array_t<float>(shape, found.corners.data()),
        py::array_t<std::int32_t>(static_cast<py::ssize_t>(found.joined.size()), found.joined.data()));
}

std::vector<std::pair<std::int32_t, std::string>> exempt_texts(const MeshReport& report) {
    std::vector<std::pair<std::int32_t, std::string>> texts;
    for (const auto& [triangle, reason] : report.exempt) {
        texts.emplace_back(triangle, mesh::message_of(reason).text());
    }
    return texts;
}

std::vector<std::string> names_of(const std::vector<mesh::NamedEntity>& entities) {
    std::vector<std::string> names;
    for (const mesh::NamedEntity& entity : entities) {
        if (entity.dimension >= 0) {
            names.push_back(mesh::name_of(entity).text());
        }
    }
    return names;
}

void bind_exempt_reason(py::module_& m) {
    using mesh::ExemptReason;
    py::class_<ExemptReason>(m, "ExemptReason",
                             "Why a triangle keeps an angle below the requested one. str() says it in words.")
        .def_property_readonly(
            "cause", [](const ExemptReason& r) { return mesh::name_of(r.cause); },
            "such as \"narrow_corner\": a name of phrases.EXEMPT")
        .def_property_readonly(
            "forced", [](const ExemptReason& r) { return mesh::is_forced(r.cause); },
            "whether the shape itself is the reason")
        .def_property_readonly(
            "angle", [](const ExemptReason& r) { return r.angle; },
            "degrees: the angle of the corner that causes it, of the shape if `forced`; -1: none")
        .def_property_readonly(
            "entities",
            [](const ExemptReason& r) {
                return names_of({r.edges[0], r.edges[1], r.vertex, r.face});
            },
            "the names of the edges and the vertex of the shape that cause it, and of its face")
        .def_property_readonly(
            "joined",
            [](const ExemptReason& r) {
                return names_of({r.joined[0], r.joined[1]});
            },
            "the names of two entities of the shape that count as one, where that makes the corner")
        .def_property_readonly(
            "apart", [](const ExemptReason& r) { return r.apart; }, "mm: how far apart these are at most; -1: none")
        .def_property_readonly(
            "message", [](const ExemptReason& r) { return text_of(mesh::message_of(r)); },
            "what it says, a MeshQuality.phrases.Text")
        .def("__str__", [](const ExemptReason& r) { return mesh::message_of(r).text(); });
}

std::vector<std::pair<std::string, std::size_t>> causes_of(const MeshReport& report) {
    std::vector<std::pair<std::string, std::size_t>> causes;
    for (const mesh::SameCause& cause : mesh::exempt_causes(report)) {
        causes.emplace_back(cause.cause, cause.count);
    }
    return causes;
}

std::string in_short(const MeshReport& report) {
    // Whether all limits are met depends on the shape, too: MeshQuality.core.verdict tells.
    const char* verdict = mesh::has_faults(report) ? ", not all limits met" : "";
    return "<MeshReport: " + mesh::in_short(report) + verdict + ">";
}

void bind_report(py::module_& m) {
    py::class_<MeshReport> report(m, "MeshReport",
                                  "What was measured on a mesh, and what happened on the way to it.\n\n"
                                  "Angles are in degrees, lengths in mm. str() gives a text of a dozen lines.");
    bind_fields(report);
    report
        .def_property_readonly(
            "max_chord_height_to", [](const MeshReport& r) { return r.to_nearest_face ? "nearest face" : "own face"; },
            "which CAD face that is the distance to: the \"own face\" of each triangle, or of each place the \"nearest "
            "face\" of all")
        .def_property_readonly("exempt", &exempt_texts, "[(triangle, why and by which entities), ...]")
        .def_property_readonly("exempt_causes", &causes_of,
                               "[(cause with # for numbers, triangles), ...], most frequent first")
        .def("__repr__", &in_short)
        .def("__str__", &mesh::to_text);
}

void bind_mesh_functions(py::module_& m) {
    m.def(
        "triangle_shapes", &triangle_shapes, py::arg("surface"),
        "float64 (T,) each: the smallest angle of each triangle in degrees, its longest edge / shortest edge, and its "
        "distortion: 1 for 60 degrees everywhere.");
    m.def("clustered", &clustered, py::arg("corners"), py::arg("wanted"),
          "(float32 (n, 3, 3), int32 (T,)): about `wanted` triangles that look like float32 (T, 3, 3) from afar, and "
          "which "
          "of them stands for each of those, or -1.");
    m.def("surface_from_arrays", &surface_from_arrays, py::arg("vertices"), py::arg("triangles"),
          py::arg("triangle_face") = py::array_t<std::int32_t>(0), py::arg("measured") = true,
          "A Surface of arrays (V, 3) and (T, 3).");
}

}  // namespace

void bind_mesh(py::module_& m) {
    bind_exempt_reason(m);
    bind_report(m);
    const auto surface = [](const py::object& self) -> const Surface& { return self.cast<const Surface&>(); };
    py::class_<Surface, SurfacePointer>(m, "Surface", "A triangle mesh in the core's memory, and its report.")
        .def_property_readonly("vertices",
                               [=](const py::object& self) {
                                   const auto& v = surface(self).mesh.vertices;
                                   return view<double>(v.data(), v.size(), 3, self);
                               })
        .def_property_readonly("triangles",
                               [=](const py::object& self) {
                                   const auto& t = surface(self).mesh.triangles;
                                   return view<std::int32_t>(t.data(), t.size(), 3, self);
                               })
        .def_property_readonly("triangle_face",
                               [=](const py::object& self) {
                                   const auto& f = surface(self).mesh.triangle_face;
                                   return view<std::int32_t>(f.data(), f.size(), 1, self);
                               })
        .def_property_readonly("triangle_solid",
                               [=](const py::object& self) {
                                   const auto& s = surface(self).mesh.triangle_solid;
                                   return view<std::int32_t>(s.data(), s.size(), 1, self);
                               })
        .def_property_readonly("triangle_opposite",
                               [=](const py::object& self) {
                                   const auto& o = surface(self).mesh.triangle_opposite;
                                   return view<std::int32_t>(o.data(), o.size(), 1, self);
                               })
        .def_property_readonly("vertex_entity",
                               [=](const py::object& self) {
                                   const auto& e = surface(self).mesh.vertex_entity;
                                   return view<std::int32_t>(e.data(), e.size(), 2, self);
                               })
        .def_property_readonly("origin", [](const Surface& self) { return value_of(self.mesh.origin); })
        .def_readonly("report", &Surface::report)
        .def_property_readonly("angle_history", &angle_history,
                               "(int64 (n,), float64 (n,)): numbers of triangles, and the smallest angle with each in "
                               "degrees, while Algorithm M ran; of TriangulateOptions.record_angles")
        .def("write", &write_surface, py::arg("path"), py::arg("format"), py::arg("names"), py::arg("colours"),
             py::arg("patch"), py::arg("given"), py::arg("scale"), py::arg("ascii"),
             "Writes the mesh in a format of src/mesh/io; `patch` has the number of each triangle's patch in `names`.")
        .def("to_bms", [](const Surface& self) {
            std::string bms;
            {
                const FreedLock free;
                bms = mesh::to_bms(self.mesh);
            }
            return py::bytes(bms);
        });
    bind_mesh_functions(m);
}

}  // namespace mq::python

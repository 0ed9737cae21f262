// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/brep_text.h"
#include "geometry/occt/placeholder_surfaces.h"
#include "geometry/occt/stream/shape_stream.h"
#include "mesh/quality/exemptions.h"
#include "mesh/quality/triangle_quality.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/bound_fields.h"
#include "python/freecad/freecad_shape.h"
#include "python/freecad/stream_cache.h"
#include "python/patches_of.h"
#include "python/progress_watch.h"
#include "python/python_lock.h"
#include "python/shared_engine.h"
#include "triangulate/incremental/mesh_cache.h"
#include "workflows/operands/triangulate_shape.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using triangulate::Result;
using triangulate::TriangulateOptions;

std::shared_ptr<Result> triangulate_shape(const FreecadShape& part, const TriangulateOptions& options,
                                          const py::object& progress, triangulate::MeshCache* cache) {
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        auto result =
            std::make_shared<Result>(workflows::triangulate_shape(engine, *part.shape, options, handle, cache));
        result->report.bridge = part.bridge;
        return result;
    });
}

mesh::MeshReport report_with_crossings(const Result& surface, const py::object& progress) {
    return watch(progress, [&](Progress& handle) { return workflows::report_with_crossings(surface, handle); });
}

mesh::MeshReport measure_against(const Result& surface, const FreecadShape& part, const py::object& progress) {
    return watch(progress, [&](Progress& handle) {
        mesh::MeshReport report = workflows::measure_against_shape(surface, *part.shape, handle);
        report.bridge = part.bridge;
        return report;
    });
}

/// The same triangles on the same entities with other vertices, measured against the shape that has these entities.
/// Triangles that were exempt from the bound on angles stay so.
std::shared_ptr<Result> with_vertices(const Result& surface, const PointArray& vertices, const FreecadShape& part,
                                      double min_angle, double chord_height, const py::object& progress) {
    auto moved = std::make_shared<Result>();
    moved->mesh = surface.mesh;
    moved->mesh.vertices = points_of(vertices);
    return watch(progress, [&](Progress& handle) {
        mesh::MeshReport& report = moved->report;
        report = mesh::measure(moved->mesh, &handle);
        report.min_angle_asked = min_angle;
        std::vector<std::pair<std::int32_t, mesh::ExemptReason>> exempt;
        for (const auto& entry : surface.report.exempt) {
            const auto& [a, b, c] = moved->mesh.triangles[entry.first];
            const std::vector<Vec3>& at = moved->mesh.vertices;
            if (mesh::min_angle_of({at[a], at[b], at[c]}) < min_angle) {
                exempt.push_back(entry);
            }
        }
        mesh::set_exempt(moved->mesh, std::move(exempt), report);
        report.chord_height_asked = chord_height;
        report = workflows::measure_against_shape(*moved, *part.shape, handle);
        report.overlaps = 0;
        report.bridge = part.bridge;
        return moved;
    });
}

/// Other triangles on the same entities: rows of corners, their faces and solids, and (dimension, index) by vertex.
/// `crossings` of them are known to cross within their bodies.
std::shared_ptr<Result> with_triangles(const Result& surface, const PointArray& vertices, const Indices& triangles,
                                       const Indices& faces, const Indices& solids, const Indices& entities,
                                       const FreecadShape& part, double chord_height, std::int64_t crossings,
                                       const py::object& progress) {
    auto made = std::make_shared<Result>();
    mesh::TriangleMesh& mesh = made->mesh;
    mesh.origin = surface.mesh.origin;
    mesh.vertices = points_of(vertices);
    mesh.triangles.resize(static_cast<std::size_t>(triangles.size()) / 3);
    for (std::size_t k = 0; k < 3 * mesh.triangles.size(); ++k) {
        mesh.triangles[k / 3][k % 3] = triangles.data()[k];
    }
    mesh.triangle_face.assign(faces.data(), faces.data() + faces.size());
    mesh.triangle_solid.assign(solids.data(), solids.data() + solids.size());
    mesh.vertex_entity.resize(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        mesh.vertex_entity[v] = {entities.data()[2 * v], entities.data()[2 * v + 1]};
    }
    return watch(progress, [&](Progress& handle) {
        made->report = mesh::measure(mesh, &handle);
        made->report.chord_height_asked = chord_height;
        made->report.self_intersections = crossings;
        made->report = workflows::measure_against_shape(*made, *part.shape, handle);
        made->report.overlaps = 0;
        made->report.bridge = part.bridge;
        return made;
    });
}

py::array_t<double> triangle_deviations(const Result& surface, const FreecadShape& part, const py::object& progress) {
    const std::vector<double> found = watch(
        progress, [&](Progress& handle) { return workflows::triangle_deviations(surface.mesh, *part.shape, handle); });
    return py::array_t<double>(static_cast<py::ssize_t>(found.size()), found.data());
}

template <typename Value>
using Names = std::vector<std::pair<Value, const char*>>;

const Names<triangulate::Insertion> kInsertions{{triangulate::Insertion::OffCentre, "off-centre"},
                                                {triangulate::Insertion::Circumcentre, "paper"}};
const Names<triangulate::Order> kOrders{{triangulate::Order::Rounds, "rounds"},
                                        {triangulate::Order::WorstFirst, "worst first"}};
const Names<triangulate::KeepEdges> kKeepEdges{{triangulate::KeepEdges::All, "all"},
                                               {triangulate::KeepEdges::Feature, "feature"}};
const Names<triangulate::Corners> kCorners{
    {triangulate::Corners::Auto, "auto"}, {triangulate::Corners::Keep, "keep"}, {triangulate::Corners::Cut, "cut"}};
const Names<triangulate::Method> kMethods{{triangulate::Method::Refine, "refine"},
                                          {triangulate::Method::Star, "star"},
                                          {triangulate::Method::Sprinkle, "sprinkle"}};
const Names<triangulate::Connectivity> kConnectivities{{triangulate::Connectivity::PseudoDelaunay, "pseudo-delaunay"},
                                                       {triangulate::Connectivity::Parametric, "parametric"}};

const Names<geometry::Evaluation> kEvaluations{{geometry::Evaluation::Fast, "fast"},
                                               {geometry::Evaluation::Native, "native"}};

/// Reads and writes an enumeration by its names.
template <typename Value>
void def_named(py::class_<TriangulateOptions>& options, const char* name, Value TriangulateOptions::*member,
               const Names<Value>& names) {
    std::string choices;
    for (const auto& entry : names) {
        choices += (choices.empty() ? "'" : ", '") + std::string(entry.second) + "'";
    }
    options.def_property(
        name,
        [member, &names](const TriangulateOptions& o) {
            const auto found =
                std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == o.*member; });
            return std::string(found->second);
        },
        [member, &names, name, choices](TriangulateOptions& o, const std::string& value) {
            const auto found =
                std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.second == value; });
            if (found == names.end()) {
                throw InvalidInput(phrases::kNotAllowed, {{"option", name},
                                                          {"value", "'" + value + "'"},
                                                          {"range", Message(phrases::kOneOf, {{"list", choices}})}});
            }
            o.*member = found->first;
        },
        ("One of " + choices).c_str());
}

void set_local_sizes(TriangulateOptions& options, const std::vector<std::tuple<int, int, double>>& sizes) {
    options.local_sizes.clear();
    for (const auto& [dimension, index, length] : sizes) {
        options.local_sizes.push_back({dimension, index, length});
    }
}

py::tuple shape_identity(const FreecadShape& part) {
    const geometry::ShapeIdentity identity = geometry::identity_of(*part.shape);
    return py::make_tuple(identity.tshape, identity.hash);
}

py::bytes brep_text(const FreecadShape& part) {
    std::string text;
    {
        const FreedLock free;
        text = geometry::write_brep_text(*part.shape);
    }
    return py::bytes(text);
}

void bind_shapes(py::module_& m) {
    m.def(
        "add_placeholder_surfaces",
        [](const py::object& part) {
            const auto shape = live_shape(part);
            if (shape != nullptr) {
                geometry::add_placeholder_surfaces(*shape);
            }
            return shape != nullptr;
        },
        py::arg("shape"),
        "Gives the faces of a Part.Shape that have triangles alone a surface, in place, so that FreeCAD can copy it. "
        "False: FreeCAD's shapes cannot be changed here.");
    m.def("brep_text", &brep_text, py::arg("shape"),
          "A Part.Shape as BREP text without triangulations: the same before and after it was shown.");
    m.def("shape_identity", &shape_identity, py::arg("shape"),
          "(address of the TShape, hash) of a Part.Shape as the core sees it.");
    m.def(
        "take", [](const FreecadShape& part) { return part.bridge; }, py::arg("shape"),
        "Takes a Part.Shape as it is now, for calls on other threads; \"live\" or \"stream\": how.");
    m.def(
        "shape_stream", [](const FreecadShape& part) { return py::bytes(geometry::write_shape_stream(*part.shape)); },
        py::arg("shape"), "A Part.Shape, as the core sees it, as Part.Shape.exportBinary writes it.");
    m.def(
        "copied_shapes",
        [] {
            return py::make_tuple(StreamCache::shared().count(), StreamCache::shared().bytes(),
                                  StreamCache::kMostBytes);
        },
        "(how many shapes that came as streams are kept, about how many bytes they take, how many they may)");
}

}  // namespace

void bind_triangulate(py::module_& m) {
    py::class_<TriangulateOptions> options(m, "TriangulateOptions", "Options of triangulate; 0 means no bound.");
    options.def(py::init<>())
        .def_property("local_sizes", nullptr, &set_local_sizes,
                      "[(dimension 0 | 1 | 2, index of the vertex, edge or face, longest edge in mm), ...]");
    options.def_property(
        "size_field", nullptr,
        [](TriangulateOptions& o, const SizeField* field) {
            o.size_field = field != nullptr ? std::make_shared<const SizeField>(*field) : nullptr;
        },
        "SizeField: lengths of edges by their places, in the shape's coordinates; None: no field");
    bind_fields(options);
    def_named(options, "insertion", &TriangulateOptions::insertion, kInsertions);
    def_named(options, "order", &TriangulateOptions::order, kOrders);
    def_named(options, "keep_edges", &TriangulateOptions::keep_edges, kKeepEdges);
    def_named(options, "corners", &TriangulateOptions::corners, kCorners);
    def_named(options, "method", &TriangulateOptions::method, kMethods);
    def_named(options, "evaluation", &TriangulateOptions::evaluation, kEvaluations);
    def_named(options, "connectivity", &TriangulateOptions::connectivity, kConnectivities);
    using triangulate::MeshCache;
    py::class_<MeshCache, std::shared_ptr<MeshCache>>(m, "MeshCache",
                                                      "Meshes of earlier calls of triangulate, for later ones.")
        .def(py::init<std::size_t, std::size_t>(), py::arg("most_runs") = MeshCache::kMostRuns,
             py::arg("most_bytes") = MeshCache::kMostBytes)
        .def_property_readonly("runs", &MeshCache::runs)
        .def_property_readonly("bytes", &MeshCache::bytes);
    m.def("triangulate", &triangulate_shape, py::arg("shape"), py::arg("options"), py::arg("progress") = py::none(),
          py::arg("cache") = py::none(),
          "Meshes a Part.Shape; returns a Surface. progress(fraction, stage) may return False to cancel. The MeshCache "
          "is "
          "used, and gets what this call leaves.");
    m.def("report_with_crossings", &report_with_crossings, py::arg("surface"), py::arg("progress") = py::none(),
          "The surface's report with its self-intersections, which are searched unless they are known.");
    m.def("measure_against", &measure_against, py::arg("surface"), py::arg("shape"), py::arg("progress") = py::none(),
          "The surface's report with its largest distance to the faces of a Part.Shape.");
    m.def("with_vertices", &with_vertices, py::arg("surface"), py::arg("vertices"), py::arg("shape"),
          py::arg("min_angle"), py::arg("chord_height"), py::arg("progress") = py::none(),
          "A Surface with the same triangles and entities and the vertices (V, 3), relative to its origin, measured "
          "against the Part.Shape that has these entities; bounds in degrees and mm for its report.");
    m.def("with_triangles", &with_triangles, py::arg("surface"), py::arg("vertices"), py::arg("triangles"),
          py::arg("triangle_face"), py::arg("triangle_solid"), py::arg("vertex_entity"), py::arg("shape"),
          py::arg("chord_height"), py::arg("crossings"), py::arg("progress") = py::none(),
          "A Surface of other triangles on the entities of the Part.Shape that a surface was made of, with the same "
          "origin, measured against it; for its report the bound on its distance in mm and how many pairs of triangles "
          "cross, -1: to be counted.");
    m.def("triangle_deviations", &triangle_deviations, py::arg("surface"), py::arg("shape"),
          py::arg("progress") = py::none(),
          "float64 (T,): the largest distance of each triangle's corners, edge middles and centroid from the faces of "
          "a Part.Shape, mm.");
    bind_shapes(m);
}

}  // namespace mq::python

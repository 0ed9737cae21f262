// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/single_grid.h"
#include "geometry/occt/brep_text.h"
#include "geometry/occt/shape_content.h"
#include "geometry/occt/shape_distance.h"
#include "geometry/occt/shape_model.h"
#include "mesh/samples.h"
#include "python/bindings.h"
#include "python/engine.h"
#include "python/part_shape.h"
#include "python/python_lock.h"
#include "python/stopwatch.h"
#include "python/watch.h"
#include "triangulate/memory.h"
#include "triangulate/triangulate.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using triangulate::Options;
using triangulate::Result;

constexpr const char* kCopied =
    "this build of FreeCAD cannot share its shapes: the mesh was made from a copy that was passed as BREP text";

/// Thin parts lose volume to the numbers of a mesh in FreeCAD, whatever the options are.
void note_lost_volume(Result& result, const PartShape& part, geometry::Engine& engine, const Progress& progress) {
    constexpr double kThin = 2e-3;  // of the volume: what the rounding of all vertices can change it by
    constexpr double kLost = 1e-2;  // of the volume
    const mesh::MeshReport& report = result.report;
    if (!report.closed || report.box.empty()) {
        return;
    }
    const double resolution = SingleGrid(report.box).resolution();
    if (report.area * resolution < kThin * std::abs(report.volume)) {
        return;
    }
    double content = 0.0;
    engine.run([&] { content = geometry::solid_content(*part.shape); }, &progress);
    const double lost = content - report.volume;
    if (content > 0.0 && std::abs(lost) > kLost * content) {
        std::array<char, 200> text;
        std::snprintf(text.data(), text.size(),
                      "the part is so thin that single precision changes its volume from %.4g to %.4g mm^3: it holds "
                      "coordinates of this part to %.2g mm",
                      content, report.volume, resolution);
        result.report.notes.emplace_back(text.data());
    }
}

std::shared_ptr<Result> triangulate_shape(const PartShape& part, const Options& options, const py::object& progress,
                                          triangulate::Memory* memory) {
    options.validate();
    geometry::Engine& engine = shared_engine();
    return watch(progress, [&](Progress& handle) {
        const Stopwatch watch_all;
        std::shared_ptr<geometry::Model> model;
        handle.stage("reading the shape", 0.0, 0.0);
        engine.run([&] { model = geometry::make_shape_model(*part.shape, &handle, geometry::Creases::Cut); }, &handle);
        const double reading = watch_all.wall();
        auto result = std::make_shared<Result>(triangulate::triangulate(engine, model, options, &handle, memory));
        result->report.seconds.insert(result->report.seconds.begin(), {"read the shape", reading});
        note_lost_volume(*result, part, engine, handle);
        result->report.cpu_seconds = watch_all.cpu();
        if (!part.live) {
            result->report.notes.push_back(kCopied);
        }
        return result;
    });
}

mesh::MeshReport measure_against(const Result& surface, const PartShape& part, const py::object& progress) {
    return watch(progress, [&](Progress& handle) {
        mesh::MeshReport report = surface.report;
        handle.stage("measuring the distance", 0.0, 1.0);
        const mesh::DeviationSamples samples = mesh::deviation_samples(surface.mesh);
        const std::vector<double> distances = geometry::distances_to_faces(*part.shape, samples.points, &handle);
        if (!distances.empty()) {
            const std::vector<double> of_triangles = samples.largest(distances);
            const auto worst = std::max_element(distances.begin(), distances.end());
            const auto triangle = std::max_element(of_triangles.begin(), of_triangles.end());
            report.max_chord_height = *worst;
            report.to_nearest_face = true;
            report.max_chord_point = samples.points[static_cast<std::size_t>(worst - distances.begin())];
            report.max_chord_triangle = static_cast<std::int32_t>(triangle - of_triangles.begin());
        }
        return report;
    });
}

py::array_t<double> triangle_deviations(const Result& surface, const PartShape& part, const py::object& progress) {
    const std::vector<double> found = watch(progress, [&](Progress& handle) {
        handle.stage("measuring the distance", 0.0, 1.0);
        const mesh::DeviationSamples samples = mesh::deviation_samples(surface.mesh);
        return samples.largest(geometry::distances_to_faces(*part.shape, samples.points, &handle));
    });
    return py::array_t<double>(static_cast<py::ssize_t>(found.size()), found.data());
}

template <typename Value>
using Names = std::vector<std::pair<Value, const char*>>;

const Names<triangulate::Insertion> kInsertions{{triangulate::Insertion::OffCentre, "off-centre"},
                                                {triangulate::Insertion::Paper, "paper"}};
const Names<triangulate::KeepEdges> kKeepEdges{{triangulate::KeepEdges::All, "all"},
                                               {triangulate::KeepEdges::Feature, "feature"}};
const Names<triangulate::Method> kMethods{{triangulate::Method::Refine, "refine"},
                                          {triangulate::Method::Star, "star"},
                                          {triangulate::Method::Sprinkle, "sprinkle"}};
const Names<triangulate::Connectivity> kConnectivities{{triangulate::Connectivity::PseudoDelaunay, "pseudo-delaunay"},
                                                       {triangulate::Connectivity::Parametric, "parametric"}};

/// Reads and writes an enumeration by its names.
template <typename Value>
void def_named(py::class_<Options>& options, const char* name, Value Options::*member, const Names<Value>& names) {
    std::string choices;
    for (const auto& entry : names) {
        choices += (choices.empty() ? "'" : ", '") + std::string(entry.second) + "'";
    }
    options.def_property(
        name,
        [member, &names](const Options& o) {
            const auto found =
                std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == o.*member; });
            return std::string(found->second);
        },
        [member, &names, name, choices](Options& o, const std::string& value) {
            const auto found =
                std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.second == value; });
            if (found == names.end()) {
                throw InvalidInput(std::string(name) + " is '" + value + "': it must be one of " + choices);
            }
            o.*member = found->first;
        },
        ("One of " + choices).c_str());
}

void set_local_sizes(Options& options, const std::vector<std::tuple<int, int, double>>& sizes) {
    options.local_sizes.clear();
    for (const auto& [dimension, index, length] : sizes) {
        options.local_sizes.push_back({dimension, index, length});
    }
}

py::tuple shape_identity(const py::object& shape, bool copy) {
    const geometry::ShapeIdentity identity = geometry::identity_of(*part_shape(shape, copy).shape);
    return py::make_tuple(identity.tshape, identity.hash);
}

py::bytes brep_text(const PartShape& part) {
    std::string text;
    {
        const FreedLock free;
        text = geometry::write_brep_text(*part.shape);
    }
    return py::bytes(text);
}

}  // namespace

void bind_triangulate(py::module_& m) {
    py::class_<Options> options(m, "TriangulateOptions", "Options of triangulate; 0 means no bound.");
    options.def(py::init<>())
        .def_readwrite("min_angle", &Options::min_angle)
        .def_readwrite("chord_height", &Options::chord_height)
        .def_readwrite("chord_height_relative", &Options::chord_height_relative)
        .def_readwrite("max_edge", &Options::max_edge)
        .def_readwrite("min_edge", &Options::min_edge)
        .def_readwrite("edges_per_circle", &Options::edges_per_circle)
        .def_readwrite("growth", &Options::growth)
        .def_property("local_sizes", nullptr, &set_local_sizes,
                      "[(dimension 0 | 1 | 2, index of the vertex, edge or face, longest edge in mm), ...]")
        .def_readwrite("feature_angle", &Options::feature_angle)
        .def_readwrite("max_triangles", &Options::max_triangles)
        .def_readwrite("allow_missing_faces", &Options::allow_missing_faces)
        .def_readwrite("polish", &Options::polish)
        .def_readwrite("seed", &Options::seed);
    def_named(options, "insertion", &Options::insertion, kInsertions);
    def_named(options, "keep_edges", &Options::keep_edges, kKeepEdges);
    def_named(options, "method", &Options::method, kMethods);
    def_named(options, "connectivity", &Options::connectivity, kConnectivities);
    using triangulate::Memory;
    py::class_<Memory, std::shared_ptr<Memory>>(m, "Memory", "What calls of triangulate leave for later ones.")
        .def(py::init<std::size_t, std::size_t>(), py::arg("most_runs") = Memory::kMostRuns,
             py::arg("most_bytes") = Memory::kMostBytes)
        .def_property_readonly("runs", &Memory::runs)
        .def_property_readonly("bytes", &Memory::bytes);
    m.def("triangulate", &triangulate_shape, py::arg("shape"), py::arg("options"), py::arg("progress") = py::none(),
          py::arg("memory") = py::none(),
          "Meshes a Part.Shape; returns a Surface. progress(fraction, stage) may return False to cancel. The Memory is "
          "used, and gets what this call leaves.");
    m.def("measure_against", &measure_against, py::arg("surface"), py::arg("shape"), py::arg("progress") = py::none(),
          "The surface's report with its largest distance to the faces of a Part.Shape.");
    m.def("triangle_deviations", &triangle_deviations, py::arg("surface"), py::arg("shape"),
          py::arg("progress") = py::none(),
          "float64 (T,): the largest distance of each triangle's corners, edge middles and centroid from the faces of "
          "a Part.Shape, mm.");
    m.def("brep_text", &brep_text, py::arg("shape"),
          "A Part.Shape as BREP text without triangulations: the same before and after it was shown.");
    m.def("shape_identity", &shape_identity, py::arg("shape"), py::arg("copy") = false,
          "(address of the TShape, hash) of a Part.Shape as the core sees it; copy=True: of its copy by BREP text.");
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.h"
#include "mesh/quality/surface_distance.h"
#include "mesh/quality/surface_verification.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/bound_fields.h"
#include "python/freecad/freecad_shape.h"
#include "python/progress_watch.h"
#include "python/shared_engine.h"
#include "workflows/boolean_of_operands.h"
#include "workflows/offset_shape.h"
#include "workflows/wrap_objects.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using boolean::BooleanOptions;
using workflows::BooleanMethod;
using workflows::BooleanReport;
using workflows::BooleanSurface;
using workflows::Operands;
using Surface = triangulate::Result;
using SurfacePointer = std::shared_ptr<Surface>;

static_assert(sizeof(std::array<std::int32_t, 2>) == 2 * sizeof(std::int32_t), "handed to NumPy as it lies in memory");

void add_operand(Operands& operands, const std::string& name, const SurfacePointer& surface, bool round,
                 const py::object& shape) {
    if (surface == nullptr && shape.is_none()) {
        throw InvalidInput(name + " has neither a surface nor a shape");
    }
    FreecadShape part;
    if (!shape.is_none()) {
        part = part_shape(shape);
    }
    operands.add({name, surface, round, std::move(part.shape), std::move(part.bridge)});
}

BooleanMethod method_from(const std::string& name) {
    if (name == "default") {
        return BooleanMethod::Default;
    }
    if (name == "exact") {
        return BooleanMethod::Exact;
    }
    if (name == "uniform") {
        return BooleanMethod::Uniform;
    }
    throw InvalidInput("method is '" + name + "': it must be 'default', 'exact' or 'uniform'");
}

/// The result of work on operands, which says how their shapes came.
template <typename Work>
auto watch_operands(const Operands& operands, const py::object& progress, Work&& work) {
    auto result = watch(progress, std::forward<Work>(work));
    result->figures.bridge = result->report.bridge = operands.bridge();
    return result;
}

/// An operation by its name, or an expression in postfix order (boolean::Expression::from).
using PythonExpression = std::variant<std::string, std::vector<std::int32_t>>;

boolean::Expression expression_from(const PythonExpression& expression, std::size_t operands) {
    const auto count = static_cast<int>(operands);
    if (const auto* name = std::get_if<std::string>(&expression)) {
        return boolean::Expression::chain(boolean::operation_from(*name), count);
    }
    return boolean::Expression::from(std::get<std::vector<std::int32_t>>(expression), count);
}

std::shared_ptr<BooleanSurface> run_boolean(const Operands& operands, const PythonExpression& operation,
                                            const BooleanOptions& options, const std::string& method,
                                            const py::object& progress) {
    const boolean::Expression wanted = expression_from(operation, operands.given().size());
    const BooleanMethod by = method_from(method);
    return watch_operands(operands, progress, [&](Progress& handle) {
        return std::make_shared<BooleanSurface>(workflows::boolean_of_operands(operands, wanted, options, by, handle));
    });
}

py::dict verify_surface(const Surface& surface, const py::object& progress) {
    const mesh::Verification check = watch(progress, [&](Progress& handle) {
        return mesh::verify(surface.mesh.vertices, surface.mesh.triangles, nullptr, 1000, &handle);
    });
    py::dict faults;
    for (std::size_t kind = 0; kind < mesh::kFaultKinds; ++kind) {
        faults[mesh::name(static_cast<mesh::FaultKind>(kind))] = check.count[kind];
    }
    return faults;
}

/// {kind: int32 (n, 2)}: the triangles at each fault, -1 beside one alone.
py::dict faults_of(const Surface& surface, std::size_t limit, const py::object& progress) {
    const mesh::Verification check = watch(progress, [&](Progress& handle) {
        return mesh::verify(surface.mesh.vertices, surface.mesh.triangles, nullptr, limit, &handle);
    });
    std::array<std::vector<std::array<std::int32_t, 2>>, mesh::kFaultKinds> found;
    for (const mesh::Fault& fault : check.faults) {
        found[static_cast<std::size_t>(fault.kind)].push_back(fault.triangles);
    }
    py::dict faults;
    for (std::size_t kind = 0; kind < mesh::kFaultKinds; ++kind) {
        py::array_t<std::int32_t> triangles({static_cast<py::ssize_t>(found[kind].size()), py::ssize_t{2}});
        std::copy_n(reinterpret_cast<const std::int32_t*>(found[kind].data()), 2 * found[kind].size(),
                    triangles.mutable_data());
        faults[mesh::name(static_cast<mesh::FaultKind>(kind))] = std::move(triangles);
    }
    return faults;
}

py::tuple surface_distance(const Surface& from, const Surface& to, const py::object& progress) {
    const mesh::SurfaceDistance distance =
        watch(progress, [&](Progress& handle) { return mesh::surface_distance(from.mesh, to.mesh, handle); });
    return py::make_tuple(distance.mean, distance.largest);
}

/// A number of each operand's surface.
template <typename T>
auto of_operands(T mesh::SurfaceTopology::*number) {
    return [number](const BooleanReport& report) {
        std::vector<T> numbers;
        for (const mesh::SurfaceTopology& operand : report.operands) {
            numbers.push_back(operand.*number);
        }
        return numbers;
    };
}

void bind_boolean_report(py::module_& m) {
    py::class_<BooleanReport, mesh::MeshReport> report(
        m, "BooleanReport", "A MeshReport of a Boolean's result, and what happened to its operands.");
    bind_fields(report);
    report
        .def_property_readonly("operand_components", of_operands(&mesh::SurfaceTopology::components),
                               "pieces of each operand that hang together by edges, beside components of the result")
        .def_property_readonly("operand_euler", of_operands(&mesh::SurfaceTopology::euler),
                               "vertices - edges + triangles of each operand, beside euler of the result")
        .def("__repr__",
             [](const BooleanReport& r) {
                 return "<BooleanReport: " + workflows::in_short(r) +
                        (workflows::met(r) ? ">" : ", not all limits met>");
             })
        .def("__str__", [](const BooleanReport& r) { return workflows::to_text(r); });
}

std::shared_ptr<BooleanSurface> offset_shape(const Operands& solid, double distance, double tolerance, int threads,
                                             const py::object& progress) {
    return watch_operands(solid, progress, [&](Progress& handle) {
        return std::make_shared<BooleanSurface>(workflows::offset_shape(solid, {distance, tolerance, threads}, handle));
    });
}

std::shared_ptr<BooleanSurface> hollow_shape(const Operands& solid, double thickness,
                                             const std::optional<std::vector<std::int32_t>>& openings, double tolerance,
                                             int threads, const py::object& progress) {
    return watch_operands(solid, progress, [&](Progress& handle) {
        return std::make_shared<BooleanSurface>(
            workflows::hollow_shape(solid, openings, {thickness, tolerance, threads}, handle));
    });
}

void bind_offsets(py::module_& m) {
    m.def("offset_shape", &offset_shape, py::arg("solid"), py::arg("distance"), py::arg("tolerance"),
          py::arg("threads"), py::arg("progress") = py::none(),
          "The offset of one of Operands; distances in mm, inward below 0; tolerance 0: the default. Returns a "
          "BooleanSurface on the CAD faces of the solid.");
    m.def("hollow_shape", &hollow_shape, py::arg("solid"), py::arg("thickness"), py::arg("openings"),
          py::arg("tolerance"), py::arg("threads"), py::arg("progress") = py::none(),
          "The wall of one of Operands, open at faces of its shape by their indices; None: closed. Lengths in mm; "
          "tolerance 0: the default. Returns a BooleanSurface.");
}

using workflows::WrapSurface;

std::shared_ptr<WrapSurface> wrap_objects(const Operands& objects, double gap, double tolerance,
                                          const std::vector<std::array<double, 3>>& dry, int threads,
                                          const py::object& progress) {
    wrap::WrapOptions options;
    options.gap = gap;
    options.spacing = tolerance;
    options.threads = threads;
    for (const std::array<double, 3>& place : dry) {
        options.dry.emplace_back(place[0], place[1], place[2]);
    }
    return watch_operands(objects, progress, [&](Progress& handle) {
        return std::make_shared<WrapSurface>(workflows::wrap_objects(objects, options, handle));
    });
}

std::array<double, 3> coordinates(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

/// (dry place, [(x, y, z), ...] of the path, narrowest place, width there)
py::tuple tuple_of(const wrap::Leak& leak) {
    std::vector<std::array<double, 3>> path;
    std::transform(leak.path.begin(), leak.path.end(), std::back_inserter(path), coordinates);
    return py::make_tuple(coordinates(leak.dry), path, coordinates(leak.narrowest), leak.width);
}

void bind_wrap(py::module_& m) {
    py::class_<WrapSurface, workflows::BooleanSurface, std::shared_ptr<WrapSurface>>(m, "WrapSurface",
                                                                                     "The wrap of some objects.")
        .def_property_readonly("distance_to_input", [](const WrapSurface& self) { return self.distance.to_input; })
        .def_property_readonly("distance_from_input", [](const WrapSurface& self) { return self.distance.from_input; })
        .def_readonly("gap_triangles", &WrapSurface::gap_triangles)
        .def_readonly("gap_area", &WrapSurface::gap_area, "mm2")
        .def_readonly("faces", &WrapSurface::faces, "how many each object has; 0: that is not known")
        .def_property_readonly(
            "leaks",
            [](const WrapSurface& self) {
                py::list leaks;
                for (const wrap::Leak& leak : self.leaks) {
                    leaks.append(tuple_of(leak));
                }
                return leaks;
            },
            "[(dry place, path, narrowest place, width in mm), ...]");
    m.def("wrap_objects", &wrap_objects, py::arg("objects"), py::arg("gap"), py::arg("tolerance"), py::arg("dry"),
          py::arg("threads"), py::arg("progress") = py::none(),
          "The outer surface of Operands without openings narrower than the gap; lengths in mm; tolerance 0: the "
          "default. Returns a WrapSurface.");
}

}  // namespace

void bind_boolean(py::module_& m) {
    bind_boolean_report(m);
    py::class_<BooleanSurface, Surface, std::shared_ptr<BooleanSurface>>(m, "BooleanSurface", "A Boolean's result.")
        .def_property_readonly("triangle_source",
                               [](const py::object& self) {
                                   const auto& source = self.cast<const BooleanSurface&>().triangle_source;
                                   return view<std::int32_t>(source.data(), source.size(), 2, self);
                               })
        .def_readonly("report", &BooleanSurface::figures);
    py::class_<BooleanOptions> options(m, "BooleanOptions", "Options of boolean; tolerance 0: what resolution gives.");
    bind_fields(options);
    options.def(py::init<>())
        .def("tolerance_for", &BooleanOptions::tolerance_for, py::arg("size"),
             "The tolerance in mm for operands whose box has this longest side: that which was requested, else that of "
             "the resolution.");
    py::class_<Operands>(m, "Operands", "Operands in their order, from their construction on being read.")
        .def(py::init([] { return Operands(shared_engine()); }))
        .def("add", &add_operand, py::arg("name"), py::arg("surface"), py::arg("round"), py::arg("shape"),
             "A Surface or None, whether it may be rounded to single precision, and a Part.Shape or None.")
        .def("size", &Operands::size, py::call_guard<py::gil_scoped_release>(), "Longest side of the box of all, mm.")
        .def("divided_length", &Operands::divided_length, py::call_guard<py::gil_scoped_release>(),
             "mm; what a resolution divides, where the method is exact.");
    m.def("boolean", &run_boolean, py::arg("operands"), py::arg("operation"), py::arg("options"), py::arg("method"),
          py::arg("progress") = py::none(),
          "A Boolean of Operands. The operation: a name, or an expression in postfix order: operand k as k, union, "
          "intersection, difference and symmetric difference as -1 to -4. Returns a BooleanSurface.");
    m.def("verify", &verify_surface, py::arg("surface"), py::arg("progress") = py::none(),
          "{kind of fault: how many} of a Surface, found exactly; contacts are counted up to 1000.");
    m.def("faults", &faults_of, py::arg("surface"), py::arg("limit"), py::arg("progress") = py::none(),
          "{kind of fault: int32 (n, 2), the triangles at each}, at most `limit` of a kind, found exactly.");
    m.def("surface_distance", &surface_distance, py::arg("start"), py::arg("target"), py::arg("progress") = py::none(),
          "Mean and largest distance of the corners and centres of a Surface's triangles from another Surface, mm.");
    bind_offsets(m);
    bind_wrap(m);
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "base/sizes/size_field.h"
#include "base/sizes/size_field_sampler.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/output/curved_mesh.h"
#include "inspection/simplex_field.h"
#include "python/array_view.h"
#include "python/bindings.h"
#include "python/python_lock.h"
#include "triangulate/work_mesh/result.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

py::array_t<double> rows_of(const std::vector<Vec3>& points) {
    const std::array<py::ssize_t, 2> shape{static_cast<py::ssize_t>(points.size()), 3};
    return py::array_t<double>(shape, points.empty() ? nullptr : points.front().data());
}

/// The values of a function at points, which several threads evaluate.
template <typename Function>
py::array_t<double> values_at(const PointArray& array, const Function& function) {
    constexpr int kBlock = 4096;  // points, evaluated in about half a millisecond
    const std::vector<Vec3> points = points_of(array);
    std::vector<double> sizes(points.size());
    {
        const FreedLock free;
        const int count = static_cast<int>(points.size());
        parallel_for((count + kBlock - 1) / kBlock, [&](int k) {
            for (int i = k * kBlock; i < std::min((k + 1) * kBlock, count); ++i) {
                sizes[static_cast<std::size_t>(i)] = function(points[static_cast<std::size_t>(i)]);
            }
        });
    }
    return array_of(sizes);
}

SizeField field_from_arrays(const std::array<double, 3>& low, double side, const Indices& children,
                            const Numbers& leaves) {
    std::vector<SizeField::Corners> corners(static_cast<std::size_t>(leaves.size()) / 8);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        std::copy_n(leaves.data() + 8 * i, 8, corners[i].begin());
    }
    return {Vec3(low[0], low[1], low[2]), side,
            std::vector<std::int32_t>(children.data(), children.data() + children.size()), std::move(corners)};
}

template <typename Mesh>
void set_size_ratio(Mesh& mesh, double ratio, const std::array<double, 3>& point, double short_share) {
    mesh.report.size_ratio = ratio;
    mesh.report.size_ratio_point = Vec3(point[0], point[1], point[2]);
    mesh.report.short_share = short_share;
}

void bind_field(py::module_& m) {
    py::class_<SizeField, std::shared_ptr<SizeField>>(m, "SizeField", "Lengths of edges by their places: an octree.")
        .def(
            "at",
            [](const SizeField& self, const PointArray& points) {
                return values_at(points, [&](const Vec3& p) { return self.at(p); });
            },
            py::arg("points"), "float64 (n,), mm, at points (n, 3); beyond the cube of the nearest")
        .def_property_readonly(
            "low",
            [](const SizeField& f) {
                return std::array<double, 3>{f.low().x(), f.low().y(), f.low().z()};
            },
            "the lowest corner of the cube, mm")
        .def_property_readonly("side", &SizeField::side, "of the cube, mm")
        .def_property_readonly(
            "children", [](const SizeField& f) { return array_of(f.children()); },
            "int32 (cells,): the first of eight children, or -1 - the index of a leaf")
        .def_property_readonly(
            "leaves",
            [](const SizeField& f) {
                const std::array<py::ssize_t, 2> shape{static_cast<py::ssize_t>(f.leaves().size()), 8};
                return py::array_t<double>(shape, f.leaves().front().data());
            },
            "float64 (leaves, 8): lengths at their corners, mm");
    m.def("size_field_from_arrays", &field_from_arrays, py::arg("low"), py::arg("side"), py::arg("children"),
          py::arg("leaves"), "The SizeField that has these arrays.");
}

inspection::SimplexField simplex_field(const PointArray& nodes, const Indices& simplices, const Numbers& values) {
    std::vector<inspection::SimplexField::Simplex> corners(static_cast<std::size_t>(simplices.size()) / 4);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        std::copy_n(simplices.data() + 4 * i, 4, corners[i].begin());
    }
    std::vector<Vec3> points = points_of(nodes);
    if (static_cast<std::size_t>(values.size()) != points.size()) {
        throw InvalidInput(phrases::kNumbersForEach,
                           {{"name", "values"}, {"count", values.size()}, {"count2", points.size()}});
    }
    return {std::move(points), corners, std::vector<double>(values.data(), values.data() + values.size())};
}

void bind_simplex_field(py::module_& m) {
    using inspection::SimplexField;
    py::class_<SimplexField>(m, "SimplexField", "Values at the nodes of simplices, and between them.")
        .def(py::init(&simplex_field), py::arg("nodes"), py::arg("simplices"), py::arg("values"),
             "float64 (N, 3), int32 (n, 4) with -1 for corners that there are not, float64 (N,)")
        .def(
            "at",
            [](const SimplexField& self, const PointArray& points) {
                return values_at(points, [&](const Vec3& p) { return self.at(p); });
            },
            py::arg("points"),
            "float64 (n,) at points (n, 3): linear in a simplex, and beyond all of them that of the nearest point")
        .def(
            "distances",
            [](const SimplexField& self, const PointArray& points) {
                return values_at(points, [&](const Vec3& p) { return self.distance(p); });
            },
            py::arg("points"), "float64 (n,): the distances of points (n, 3) from the simplices, mm; 0 inside");
}

}  // namespace

void bind_sizes(py::module_& m) {
    bind_field(m);
    bind_simplex_field(m);
    py::class_<SizeFieldSampler>(
        m, "SizeFieldSampler",
        "Makes a SizeField of a function: give() it the values at wanted() points until there are none.")
        .def(py::init([](const std::array<double, 3>& low, const std::array<double, 3>& high, double error,
                         int least_depth, std::size_t most_samples) {
                 Box box;
                 box.add(Vec3(low[0], low[1], low[2]));
                 box.add(Vec3(high[0], high[1], high[2]));
                 return SizeFieldSampler(box, error, least_depth, most_samples);
             }),
             py::arg("low"), py::arg("high"), py::arg("error"), py::arg("least_depth"), py::arg("most_samples"))
        .def(
            "mark",
            [](SizeFieldSampler& self, const PointArray& points, const Numbers& lengths) {
                const std::vector<Vec3> at = points_of(points);
                for (std::size_t i = 0; i < at.size(); ++i) {
                    self.mark(at[i], lengths.data()[i]);
                }
            },
            py::arg("points"), py::arg("lengths"), "Cells at (n, 3) points are divided down to these lengths.")
        .def(
            "restrict_to",
            [](SizeFieldSampler& self, const PointArray& points, int depth) {
                self.restrict_to(points_of(points), depth);
            },
            py::arg("points"), py::arg("depth"),
            "Cells deeper than that are divided near (n, 3) points of a surface only.")
        .def("restart", &SizeFieldSampler::restart, "Starts again with further marks; values that are known stay.")
        .def(
            "wanted", [](SizeFieldSampler& self) { return rows_of(self.wanted()); },
            "float64 (n, 3): points at which values are needed; none: the field is complete")
        .def(
            "give",
            [](SizeFieldSampler& self, const Numbers& sizes) {
                self.give(sizes.data(), static_cast<std::size_t>(sizes.size()));
            },
            py::arg("sizes"), "The values at the points that wanted() gave last, above 0.")
        .def("field", &SizeFieldSampler::field, "The SizeField.")
        .def_property_readonly("samples", &SizeFieldSampler::samples, "number of values")
        .def_property_readonly("unresolved", &SizeFieldSampler::unresolved,
                               "number of cells that have the least of their values");
    m.def("set_size_ratio", &set_size_ratio<triangulate::Result>, py::arg("mesh"), py::arg("ratio"), py::arg("point"),
          py::arg("short_share"),
          "Puts what was measured against a size field into the report of a Surface or a Curved.");
    m.def("set_size_ratio", &set_size_ratio<curve::CurvedMesh>, py::arg("mesh"), py::arg("ratio"), py::arg("point"),
          py::arg("short_share"), "Likewise.");
}

}  // namespace mq::python

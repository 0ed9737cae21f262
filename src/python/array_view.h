// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <vector>

#include "base/error.h"
#include "base/vec.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::python {

/// A read-only NumPy view of `count` rows of `width` numbers. `owner` lives as long as the view.
template <typename T>
pybind11::array view(const void* data, std::size_t count, std::size_t width, const pybind11::object& owner) {
    std::vector<pybind11::ssize_t> shape{static_cast<pybind11::ssize_t>(count)};
    if (width > 1) {
        shape.push_back(static_cast<pybind11::ssize_t>(width));
    }
    pybind11::array array(pybind11::dtype::of<T>(), shape, static_cast<const T*>(data), owner);
    array.attr("setflags")(pybind11::arg("write") = false);
    return array;
}

/// A NumPy array with a copy of the numbers.
template <typename T>
pybind11::array_t<T> array_of(const std::vector<T>& list) {
    return pybind11::array_t<T>(static_cast<pybind11::ssize_t>(list.size()), list.data());
}

using PointArray = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// The points in the rows of an array. @throws InvalidInput where it has not three columns.
inline std::vector<Vec3> points_of(const PointArray& nodes) {
    if (nodes.ndim() != 2 || nodes.shape(1) != 3) {
        throw InvalidInput(phrases::kColumns, {{"name", "nodes"}, {"count", 3}});
    }
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(nodes.shape(0)));
    const double* at = nodes.data();
    for (pybind11::ssize_t i = 0; i < nodes.shape(0); ++i, at += 3) {
        points.emplace_back(at[0], at[1], at[2]);
    }
    return points;
}

}  // namespace mq::python

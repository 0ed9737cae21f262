// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <vector>

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

}  // namespace mq::python

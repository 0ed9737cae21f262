// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

namespace mq::python {

/// Named values as a dictionary, in their order.
template <typename T>
pybind11::dict dict_of(const std::vector<std::pair<std::string, T>>& pairs) {
    pybind11::dict result;
    for (const auto& [name, value] : pairs) {
        result[pybind11::str(name)] = value;
    }
    return result;
}

}  // namespace mq::python

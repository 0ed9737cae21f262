// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesh/io/export_mesh.h"

namespace mq::python {

using Names = std::vector<std::string>;
using Colours = std::vector<std::optional<std::array<std::uint8_t, 3>>>;
using Indices = pybind11::array_t<std::int32_t, pybind11::array::c_style | pybind11::array::forcecast>;

/// Patches as Python has them: names, colours (None: none) and by triangle the number of its patch.
inline mesh::Patches patches_of(const Names& names, const Colours& colours, const Indices& patch, bool given) {
    mesh::Patches patches;
    for (std::size_t i = 0; i < names.size(); ++i) {
        mesh::Group& group = patches.groups.emplace_back(mesh::Group{names[i]});
        if (i < colours.size() && colours[i]) {
            group.colour = *colours[i];
        }
    }
    patches.of_triangle.assign(patch.data(), patch.data() + patch.size());
    patches.given = given;
    return patches;
}

}  // namespace mq::python

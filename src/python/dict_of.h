// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh/quality/mesh_report.h"

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

/// (CAD face, CAD face, pairs of their triangles that cross) for each crossing.
inline std::vector<std::tuple<std::int32_t, std::int32_t, std::size_t>> crossings_of(
    const std::vector<mesh::FaceCrossing>& crossings) {
    std::vector<std::tuple<std::int32_t, std::int32_t, std::size_t>> result;
    for (const mesh::FaceCrossing& crossing : crossings) {
        result.emplace_back(crossing.faces[0], crossing.faces[1], crossing.pairs);
    }
    return result;
}

/// [(body, body, how they overlap), ...]
inline std::vector<std::tuple<std::string, std::string, std::string>> overlaps_of(
    const std::vector<mesh::BodyOverlap>& overlaps) {
    std::vector<std::tuple<std::string, std::string, std::string>> result;
    for (const mesh::BodyOverlap& found : overlaps) {
        result.emplace_back(found.bodies[0], found.bodies[1], mesh::to_string(found.kind));
    }
    return result;
}

/// [(solid, solid, triangles, mm^2), ...]
inline std::vector<std::tuple<std::int32_t, std::int32_t, std::size_t, double>> contacts_of(
    const std::vector<mesh::SolidContact>& contacts) {
    std::vector<std::tuple<std::int32_t, std::int32_t, std::size_t, double>> result;
    for (const mesh::SolidContact& contact : contacts) {
        result.emplace_back(contact.solids[0], contact.solids[1], contact.triangles, contact.area);
    }
    return result;
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "mesh/quality/mesh_report.h"
#include "python/bindings.h"

namespace mq::python {

/// A read-only array of three numbers.
inline pybind11::array value_of(const Vec3& p) {
    pybind11::array_t<double> array(3);
    std::copy(p.data(), p.data() + 3, array.mutable_data());
    array.attr("setflags")(pybind11::arg("write") = false);
    return std::move(array);
}

inline pybind11::object value_of(const Box& box) {
    return box.empty() ? pybind11::none()
                       : pybind11::object(pybind11::make_tuple(value_of(box.low), value_of(box.high)));
}

inline pybind11::tuple value_of(const mesh::FaceCrossing& crossing) {
    return pybind11::make_tuple(crossing.faces[0], crossing.faces[1], crossing.pairs);
}

inline pybind11::tuple value_of(const mesh::BodyOverlap& found) {
    return pybind11::make_tuple(found.bodies[0], found.bodies[1], mesh::to_string(found.kind));
}

inline pybind11::tuple value_of(const mesh::SolidContact& contact) {
    return pybind11::make_tuple(contact.solids[0], contact.solids[1], contact.triangles, contact.area);
}

inline pybind11::object value_of(const Message& message) {
    return text_of(message);
}

template <typename T>
pybind11::object value_of(const T& value) {
    return pybind11::cast(value);
}

template <typename T>
pybind11::list value_of(const std::vector<T>& values) {
    pybind11::list list;
    for (const T& value : values) {
        list.append(value_of(value));
    }
    return list;
}

/// Named values as a dictionary, in their order.
template <typename T>
pybind11::dict value_of(const std::vector<std::pair<std::string, T>>& pairs) {
    pybind11::dict result;
    for (const auto& [name, value] : pairs) {
        result[pybind11::str(name)] = value;
    }
    return result;
}

/// Binds a field as a property with its value for Python; a MeshReport within a report is bound itself.
template <typename Bound, typename Owner, typename T>
void bind_field(Bound& bound, const char* name, T Owner::*field, const char* said) {
    if constexpr (std::is_same_v<T, mesh::MeshReport>) {
        bound.def_readonly(name, field, said);
    } else {
        bound.def_property_readonly(
            name, [field](const Owner& owner) { return value_of(owner.*field); }, said);
    }
}

/// Binds notes, to which Python may add its own.
template <typename Bound, typename Owner>
void bind_notes(Bound& bound, std::vector<Message> Owner::*notes, const char* said) {
    bound.def_property(
        "notes", [notes](const Owner& owner) { return value_of(owner.*notes); },
        [notes](Owner& owner, const std::vector<std::string>& texts) {
            (owner.*notes).clear();
            std::transform(texts.begin(), texts.end(), std::back_inserter(owner.*notes), &Message::value);
        },
        said);
}

}  // namespace mq::python

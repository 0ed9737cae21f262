// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

class TopoDS_Shape;

namespace mq::python {

/// A Part.Shape in the form that the core uses.
struct FreecadShape {
    std::shared_ptr<const TopoDS_Shape> shape;
    /// "live": it shares its TShape with the document's shape; "stream": a copy that came as binary BREP
    std::string bridge;
};

/// True when `object` is a Part.Shape (or of a class derived from it).
bool is_part_shape(pybind11::handle object);

/// Takes a shape by the bridge that the environment variable MESHQUALITY_BRIDGE names; without it live where FreeCAD
/// and the core use one OpenCASCADE in memory, else as a stream.
/// @throws InvalidInput for a null shape, an unknown bridge, or one that does not work here
FreecadShape part_shape(pybind11::handle object);

}  // namespace mq::python

namespace pybind11::detail {

/// Functions that take `const FreecadShape&` accept Part.Shape objects.
template <>
struct type_caster<mq::python::FreecadShape> {
    PYBIND11_TYPE_CASTER(mq::python::FreecadShape, const_name("Part.Shape"));

    bool load(handle source, bool) {
        if (!mq::python::is_part_shape(source)) {
            return false;
        }
        value = mq::python::part_shape(source);
        return true;
    }
};

}  // namespace pybind11::detail

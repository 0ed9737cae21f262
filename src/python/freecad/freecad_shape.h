// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

class TopoDS_Shape;

namespace mq::python {

/// A Part.Shape in the form that the core uses.
struct FreecadShape {
    const TopoDS_Shape* shape = nullptr;       ///< shares its TShape with the document's shape when `live`
    bool live = true;                          ///< false: a copy that came as BREP text
    pybind11::object proxy;                    ///< keeps a live shape alive
    std::shared_ptr<const TopoDS_Shape> copy;  ///< keeps a copy alive
};

/// True when `object` is a Part.Shape (or of a class derived from it).
bool is_part_shape(pybind11::handle object);

/// Takes the live shape through FreeCAD's interoperability call, or a copy where this build of FreeCAD cannot give it.
/// @throws InvalidInput for a null shape.
FreecadShape part_shape(pybind11::handle object, bool force_copy = false);

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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/freecad/freecad_shape.h"

#ifndef MESHQUALITY_OWN_OPENCASCADE
#include <swigpyrun.h>
#endif

#include <string>

#include "base/error.h"
#include "geometry/occt/brep_text.h"

namespace py = pybind11;

namespace mq::python {

namespace {

#ifdef MESHQUALITY_OWN_OPENCASCADE
/// FreeCAD's shapes are of another OpenCASCADE.
void take_live(py::handle, FreecadShape&) {}
#else
/// SWIG's type of TopoDS_Shape in the runtime that all SWIG modules of the process share; null when FreeCAD was built
/// with another version of that runtime. The type needs a Python class, or the shape's destructor would never be
/// called.
swig_type_info* shape_type() {
    // Without any SWIG module in the process there is no runtime, hence the import first.
    const py::module_ registrar = py::module_::import("MeshQuality._occ_shape");
    swig_type_info* type = SWIG_TypeQuery("TopoDS_Shape *");
    if (type != nullptr && type->clientdata == nullptr) {
        py::dict members;
        members["__swig_destroy__"] = registrar.attr("delete_TopoDS_Shape");
        members["__module__"] = "MeshQuality._occ_shape";
        const py::object metaclass = py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(&PyType_Type));
        const py::tuple bases = py::make_tuple(py::module_::import("builtins").attr("object"));
        registrar.attr("TopoDS_Shape_swigregister")(metaclass("TopoDS_Shape", bases, members));
    }
    return type;
}

/// Leaves `shape` null when the interoperability call does not work in this build of FreeCAD.
void take_live(py::handle object, FreecadShape& result) {
    swig_type_info* type = shape_type();
    if (type == nullptr) {
        return;
    }
    try {
        result.proxy = py::module_::import("Part").attr("__toPythonOCC__")(object);
    } catch (const py::error_already_set&) {
        return;
    }
    void* pointer = nullptr;
    if (SWIG_IsOK(SWIG_ConvertPtr(result.proxy.ptr(), &pointer, type, 0))) {
        result.shape = static_cast<const TopoDS_Shape*>(pointer);
    }
}
#endif

}  // namespace

bool is_part_shape(py::handle object) {
    const py::dict modules = py::module_::import("sys").attr("modules");
    return modules.contains("Part") && py::isinstance(object, modules["Part"].attr("Shape"));
}

FreecadShape part_shape(py::handle object, bool force_copy) {
    if (object.attr("isNull")().cast<bool>()) {
        throw InvalidInput("the shape is null: it has no geometry");
    }
    FreecadShape result;
    if (!force_copy) {
        take_live(object, result);
    }
    if (result.shape == nullptr) {
        result.live = false;
        result.copy = geometry::read_brep_text(object.attr("exportBrepToString")().cast<std::string>());
        result.shape = result.copy.get();
    }
    return result;
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/freecad/freecad_shape.h"

#ifndef MESHQUALITY_OWN_OPENCASCADE
#include <swigpyrun.h>
#endif

#include <cstdlib>
#include <optional>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/shape_model.h"
#include "geometry/occt/stream/canonical_locations.h"
#include "geometry/occt/stream/shape_stream.h"
#include "geometry/occt/sub_shapes.h"
#include "python/freecad/stream_cache.h"

namespace py = pybind11;

namespace mq::python {

namespace {

constexpr const char* kLive = "live";
constexpr const char* kStream = "stream";

#ifdef MESHQUALITY_OWN_OPENCASCADE
std::shared_ptr<const TopoDS_Shape> take_live(py::handle) {
    return nullptr;
}

Message why_not_live() {
    return phrases::kOwnKernel;
}
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

/// The live shape; null when the interoperability call does not work in this build of FreeCAD.
std::shared_ptr<const TopoDS_Shape> take_live(py::handle object) {
    try {
        swig_type_info* type = shape_type();
        const py::object proxy = py::module_::import("Part").attr("__toPythonOCC__")(object);
        void* pointer = nullptr;
        if (type != nullptr && SWIG_IsOK(SWIG_ConvertPtr(proxy.ptr(), &pointer, type, 0))) {
            return geometry::kept(*static_cast<const TopoDS_Shape*>(pointer));
        }
    } catch (const py::error_already_set&) {
        // The call, or the module for it, is missing.
    }
    return nullptr;
}

/// Why shapes cannot be taken live; empty where they can. Versions are compared first: the layout of another one may
/// differ.
Message why_not_live() {
    const py::module_ part = py::module_::import("Part");
    const std::string theirs = py::str(part.attr("OCC_VERSION"));
    if (theirs != geometry::occt_version()) {
        return {phrases::kOtherKernel, {{"value", theirs}, {"value2", geometry::occt_version()}}};
    }
    const std::shared_ptr<const TopoDS_Shape> probe = take_live(part.attr("Vertex")(0.0, 0.0, 0.0));
    if (probe == nullptr) {
        return phrases::kNotShared;
    }
    return geometry::is_of_this_kernel(*probe) ? Message() : Message(phrases::kOwnKernel);
}
#endif

/// The same of this process, which stays as it is.
const Message& obstacle() {
    static std::optional<Message> why;
    if (!why) {
        why = why_not_live();
    }
    return *why;
}

/// The bridge that is asked for; empty: none is.
std::string asked_bridge() {
    const char* const value = std::getenv("MESHQUALITY_BRIDGE");
    const std::string asked = value == nullptr ? "" : value;
    if (!asked.empty() && asked != kLive && asked != kStream) {
        throw InvalidInput(phrases::kNotAllowed, {{"option", "MESHQUALITY_BRIDGE"},
                                                  {"value", "'" + asked + "'"},
                                                  {"range", Message(phrases::kOneOf, {{"list", "'live', 'stream'"}})}});
    }
    return asked;
}

}  // namespace

bool is_part_shape(py::handle object) {
    const py::dict modules = py::module_::import("sys").attr("modules");
    return modules.contains("Part") && py::isinstance(object, modules["Part"].attr("Shape"));
}

std::shared_ptr<const TopoDS_Shape> live_shape(py::handle object) {
    return obstacle().empty() ? take_live(object) : nullptr;
}

FreecadShape part_shape(py::handle object) {
    if (object.attr("isNull")().cast<bool>()) {
        throw InvalidInput(phrases::kShapeNull);
    }
    const std::string asked = asked_bridge();
    if (asked != kStream) {
        std::shared_ptr<const TopoDS_Shape> live = live_shape(object);
        if (live != nullptr) {
            return {geometry::with_canonical_locations(*live), kLive};
        }
        if (asked == kLive) {
            throw InvalidInput(phrases::kBridgeNotLive,
                               {{"phrase", obstacle().empty() ? Message(phrases::kNotShared) : obstacle()}});
        }
    }
    return {StreamCache::shared().copy_of(object), kStream};
}

}  // namespace mq::python

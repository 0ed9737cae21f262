// SPDX-License-Identifier: LGPL-2.1-or-later
#include <system_error>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "python/bindings.h"

namespace py = pybind11;

namespace mq::python {

namespace {

/// The classes live in Python, so that they can be caught where the extension module is missing.
void raise(const char* name, const Error& error) {
    const py::object type = py::module_::import("MeshQuality.errors").attr(name);
    PyErr_SetObject(type.ptr(), text_of(error.message()).ptr());
}

/// Calls a function of Python; an error of ours that it raises gets no traceback. Other errors keep theirs.
py::object call_without_traceback(const py::function& function, const py::args& arguments) {
    const py::object ours = py::module_::import("MeshQuality.errors").attr("Error");
    const py::object found = py::reinterpret_steal<py::object>(PyObject_CallObject(function.ptr(), arguments.ptr()));
    if (!found) {
        PyObject* type = nullptr;
        PyObject* value = nullptr;
        PyObject* traceback = nullptr;
        PyErr_Fetch(&type, &value, &traceback);
        if (PyErr_GivenExceptionMatches(type, ours.ptr())) {
            Py_CLEAR(traceback);
        }
        PyErr_Restore(type, value, traceback);
        throw py::error_already_set();
    }
    return found;
}

/// The argument of MeshQuality.phrases.from_data.
py::object data_of(const Message& message) {
    if (message.is_value) {
        // Names of files need not be UTF-8.
        PyObject* text =
            PyUnicode_DecodeUTF8(message.phrase.data(), static_cast<py::ssize_t>(message.phrase.size()), "replace");
        if (text == nullptr) {
            throw py::error_already_set();
        }
        return py::reinterpret_steal<py::object>(text);
    }
    py::dict places;
    for (const Place& place : message.places) {
        places[place.name.c_str()] = data_of(place.content);
    }
    py::dict data;
    data["phrase"] = message.phrase;
    data["places"] = places;
    return std::move(data);
}

}  // namespace

py::object text_of(const Message& message) {
    const py::object data = data_of(message);
    return message.is_value ? data : py::module_::import("MeshQuality.phrases").attr("from_data")(data);
}

void bind_errors(py::module_& m) {
    m.def(
        "without_traceback",
        [](const py::function& function) {
            return py::cpp_function([function](const py::args& arguments) {  //
                return call_without_traceback(function, arguments);
            });
        },
        "The function, but the errors of MeshQuality that it raises have no traceback: for callers who print that for "
        "users");
    py::register_exception_translator([](std::exception_ptr error) {
        try {
            std::rethrow_exception(error);
        } catch (const InvalidInput& e) {
            raise("InvalidInput", e);
        } catch (const TopologyError& e) {
            raise("TopologyError", e);
        } catch (const GeometryError& e) {
            raise("GeometryError", e);
        } catch (const Cancelled& e) {
            raise("Cancelled", e);
        } catch (const IoError& e) {
            raise("IoError", e);
        } catch (const Error& e) {
            raise("Error", e);
        } catch (const std::system_error& e) {
            raise("Error", Error(phrases::kSystemLimits, {{"text", e.what()}}));
        }
    });
}

}  // namespace mq::python

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/error.h"
#include "python/bindings.h"

namespace py = pybind11;

namespace mq::python {

namespace {

/// The classes live in Python, so that they can be caught where the extension module is missing.
void raise(const char* name, const std::exception& error) {
    const py::object type = py::module_::import("MeshQuality.errors").attr(name);
    PyErr_SetString(type.ptr(), error.what());
}

}  // namespace

void bind_errors(py::module_&) {
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
        }
    });
}

}  // namespace mq::python

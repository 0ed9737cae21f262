// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/freecad/freecad_mesh.h"

#include <cstring>
#include <istream>
#include <ostream>
#include <string>

#include "base/system/system.h"

namespace py = pybind11;

namespace mq::python {

namespace {

/// A symbol of the library that contains FreeCAD's module Mesh; null when it has none of that name.
void* symbol(const char* name) {
    static const auto library = py::module_::import("Mesh").attr("__file__").cast<std::string>();
    return symbol_of_library(library, name);
}

template <typename Function>
Function function(const char* name) {
    return reinterpret_cast<Function>(symbol(name));
}

constexpr int kBms = 1;  // MeshCore::MeshIO::BMS

// Member functions take their object as first argument in the C++ ABI that gives them these names.
struct Functions {
    void* (*object_of)(const void*) = function<void* (*)(const void*)>("_ZNK4Mesh6MeshPy16getMeshObjectPtrEv");
    // The overload that only reads: without a format FreeCAD checks the mesh besides, and shows its progress.
    bool (*load)(void*, std::istream&, int, void*) = function<bool (*)(void*, std::istream&, int, void*)>(
        "_ZN4Mesh10MeshObject4loadERSiN8MeshCore6MeshIO6FormatEPNS2_8MaterialE");
    void (*save)(const void*,
                 std::ostream&) = function<void (*)(const void*, std::ostream&)>("_ZNK4Mesh10MeshObject4saveERSo");
    void (*add_segment)(void*, const std::vector<unsigned long>&) =
        function<void (*)(void*, const std::vector<unsigned long>&)>(
            "_ZN4Mesh10MeshObject10addSegmentERKSt6vectorImSaImEE");
    const char* table = function<const char*>("_ZTVN4Mesh6MeshPyE");

    bool complete() const {
        return object_of != nullptr && load != nullptr && save != nullptr && add_segment != nullptr && table != nullptr;
    }
};

const Functions& functions() {
    static const Functions found;
    return found;
}

}  // namespace

FreecadMesh::FreecadMesh(py::handle mesh) {
    if (!py::isinstance(mesh, py::module_::import("Mesh").attr("Mesh")) || !functions().complete()) {
        return;
    }
    // FreeCAD's class has virtual functions and derives from PyObject, which has none: its pointer to the table of
    // these functions comes first. Such a pointer skips two entries of the table.
    const char* const whole = reinterpret_cast<const char*>(mesh.ptr()) - sizeof(void*);
    const char* table = nullptr;
    std::memcpy(&table, whole, sizeof(table));
    if (table == functions().table + 2 * sizeof(void*)) {
        object_ = functions().object_of(whole);
    }
}

bool FreecadMesh::read(std::istream& bms) const {
    return functions().load(object_, bms, kBms, nullptr);
}

void FreecadMesh::write(std::ostream& bms) const {
    functions().save(object_, bms);
}

void FreecadMesh::add_segment(const std::vector<unsigned long>& triangles) const {
    functions().add_segment(object_, triangles);
}

}  // namespace mq::python

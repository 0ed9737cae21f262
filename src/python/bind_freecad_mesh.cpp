// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "mesh/io/io.h"
#include "python/bindings.h"
#include "python/freecad/freecad_mesh.h"
#include "python/python_lock.h"
#include "triangulate/triangulate.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using Surface = triangulate::Result;

/// The triangles of each CAD face, faces in ascending order.
std::vector<std::vector<unsigned long>> triangles_by_face(const std::vector<int>& triangle_face) {
    std::vector<unsigned long> order(triangle_face.size());
    std::iota(order.begin(), order.end(), 0UL);
    std::stable_sort(order.begin(), order.end(), [&](unsigned long a, unsigned long b) {
        return triangle_face[static_cast<std::size_t>(a)] < triangle_face[static_cast<std::size_t>(b)];
    });
    std::vector<std::vector<unsigned long>> faces;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || triangle_face[order[i]] != triangle_face[order[i - 1]]) {
            faces.emplace_back();
        }
        faces.back().push_back(order[i]);
    }
    return faces;
}

/// Fills a Mesh.Mesh that has no other user yet; false where this build of FreeCAD does not support it.
bool fill_mesh(const py::object& mesh, const Surface& surface) {
    const FreecadMesh inner(mesh);
    if (!inner.reachable()) {
        return false;
    }
    const FreedLock free;
    std::istringstream bms(mesh::to_bms(surface.mesh));
    if (!inner.read(bms)) {
        return false;
    }
    for (const std::vector<unsigned long>& face : triangles_by_face(surface.mesh.triangle_face)) {
        inner.add_segment(face);
    }
    return true;
}

/// A Mesh.Mesh that has no other user meanwhile, in FreeCAD's binary format; None where this build does not support it.
py::object bms_of_mesh(const py::object& mesh) {
    const FreecadMesh inner(mesh);
    if (!inner.reachable()) {
        return py::none();
    }
    auto bms = std::make_unique<std::string>();
    {
        const FreedLock free;
        std::ostringstream stream;
        inner.write(stream);
        *bms = stream.str();
    }
    const std::string& bytes = *bms;
    const py::capsule owner(bms.release(), [](void* text) { delete static_cast<std::string*>(text); });
    return py::array_t<std::uint8_t>(static_cast<py::ssize_t>(bytes.size()),
                                     reinterpret_cast<const std::uint8_t*>(bytes.data()), owner);
}

}  // namespace

void bind_freecad_mesh(py::module_& m) {
    m.def("fill_mesh", &fill_mesh, py::arg("mesh"), py::arg("surface"),
          "Fills an empty Mesh.Mesh with a Surface, one segment a CAD face, while Python's lock is free. False: this "
          "build of FreeCAD does not let us.");
    m.def("bms_of_mesh", &bms_of_mesh, py::arg("mesh"),
          "uint8 (n,): a Mesh.Mesh without its placement in FreeCAD's binary format, written while Python's lock is "
          "free; no other thread may change it meanwhile. None: this build of FreeCAD does not let us.");
}

}  // namespace mq::python

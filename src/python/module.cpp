// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "geometry/occt/shape_model.h"
#include "mesh/intersection/self_intersection.h"
#include "python/bindings.h"
#include "python/progress_watch.h"
#include "python/running_work.h"

namespace py = pybind11;

namespace {

#ifndef MESHQUALITY_OWN_OPENCASCADE
std::string major_minor(const std::string& version) {
    return version.substr(0, version.find('.', version.find('.') + 1));
}

/// A core that is linked with OpenCASCADE's shared libraries uses those of FreeCAD, so both sides must agree on their
/// layout.
void require_same_kernel() {
    py::str theirs;
    try {
        theirs = py::module_::import("Part").attr("OCC_VERSION");
    } catch (const py::error_already_set& e) {
        if (e.matches(PyExc_ImportError)) {
            return;
        }
        throw;
    }
    const std::string ours = mq::geometry::occt_version();
    if (major_minor(ours) != major_minor(theirs)) {
        throw py::import_error("MeshQuality was built with OpenCASCADE " + ours + ", but this FreeCAD has " +
                               std::string(theirs) + ": rebuild it with the OpenCASCADE of this FreeCAD");
    }
}
#endif

}  // namespace

PYBIND11_MODULE(_core, m) {
    m.doc() = "The C++ core of MeshQuality. Scripts use the package MeshQuality.";
#ifndef MESHQUALITY_OWN_OPENCASCADE
    require_same_kernel();
#endif
    m.attr("occt_version") = mq::geometry::occt_version();
    m.attr("MOST_CROSSINGS") = mq::mesh::kMostCounted;
    mq::python::bind_errors(m);
    mq::python::bind_freecad_mesh(m);
    mq::python::bind_mesh(m);
    mq::python::bind_triangulate(m);
    mq::python::bind_curve(m);
    mq::python::bind_elements(m);
    mq::python::bind_given(m);
    mq::python::bind_boolean(m);
    mq::python::bind_improve(m);
    mq::python::bind_inspection(m);
    mq::python::bind_sizes(m);
    mq::python::bind_deviation(m);
#ifdef MESHQUALITY_SCHEDULE_TRACE
    mq::python::bind_schedule(m);
#endif
    m.def(
        "waits",
        [] {
            std::vector<std::pair<std::string, py::object>> found;
            for (const auto& [title, what] : mq::Waits::all_lasting(mq::python::kLongestUnnamedWait)) {
                found.emplace_back(title, mq::python::text_of(what));
            }
            return found;
        },
        "[(name of a thread, what its call waits for and cannot interrupt, a MeshQuality.phrases.Text), ...]");
    mq::python::end_with_process();
    py::module_::import("atexit").attr("register")(py::cpp_function(&mq::python::end_with_python));
}

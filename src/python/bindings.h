// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "base/message.h"

/// The bindings of the extension module MeshQuality._core, one function for each topic.
namespace mq::python {

void bind_boolean(pybind11::module_& m);
void bind_curve(pybind11::module_& m);
void bind_given(pybind11::module_& m);
void bind_curved_mesh(pybind11::module_& m);
void bind_elements(pybind11::module_& m);
void bind_errors(pybind11::module_& m);
void bind_freecad_mesh(pybind11::module_& m);
void bind_improve(pybind11::module_& m);
void bind_inspection(pybind11::module_& m);
void bind_deviation(pybind11::module_& m);
void bind_mesh(pybind11::module_& m);
#ifdef MESHQUALITY_SCHEDULE_TRACE
void bind_schedule(pybind11::module_& m);
#endif
void bind_sizes(pybind11::module_& m);
void bind_triangulate(pybind11::module_& m);

/// A MeshQuality.phrases.Text, or the text of a message that is a value.
pybind11::object text_of(const Message& message);

}  // namespace mq::python

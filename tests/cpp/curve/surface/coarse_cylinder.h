// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <memory>

#include "geometry/occt/shape_model.h"

namespace mq::curve {

inline std::shared_ptr<geometry::Model> cylinder() {
    return geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape());
}

}  // namespace mq::curve

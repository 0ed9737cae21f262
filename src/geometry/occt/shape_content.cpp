// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/shape_content.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <string>

#include "base/error.h"

namespace mq::geometry {

double solid_content(const TopoDS_Shape& shape) {
    try {
        double sum = 0.0;
        for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) {
            GProp_GProps properties;
            BRepGProp::VolumeProperties(solids.Current(), properties);
            sum += std::abs(properties.Mass());
        }
        return sum;
    } catch (const Standard_Failure& failure) {
        const char* text = failure.GetMessageString();
        throw GeometryError(std::string("OpenCASCADE cannot measure the part's volume: ") +
                            (text != nullptr ? text : ""));
    }
}

}  // namespace mq::geometry

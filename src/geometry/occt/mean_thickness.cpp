// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/mean_thickness.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/evaluation/failure_text.h"

namespace mq::geometry {

std::vector<double> mean_thicknesses(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape bodies;
    TopExp::MapShapes(shape, TopAbs_SOLID, bodies);
    if (bodies.IsEmpty()) {
        bodies.Add(shape);
    }
    std::vector<double> found;
    try {
        for (int i = 1; i <= bodies.Extent(); ++i) {
            GProp_GProps content;
            GProp_GProps skin;
            BRepGProp::VolumeProperties(bodies(i), content);
            BRepGProp::SurfaceProperties(bodies(i), skin);
            const double thickness = 2.0 * std::abs(content.Mass()) / skin.Mass();
            if (skin.Mass() != 0.0 && thickness > 0.0) {
                found.push_back(thickness);
            }
        }
    } catch (const Standard_Failure& failure) {
        throw GeometryError(phrases::kKernelFails, {{"text", failure_text(failure)}});
    }
    return found;
}

}  // namespace mq::geometry

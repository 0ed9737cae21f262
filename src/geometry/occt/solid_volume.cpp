// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/solid_volume.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/waits.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::geometry {

namespace {

/// Relative error of the volume under each face. Without such a bound BRepGProp takes a fixed number of Gauss points,
/// which has errors of 1 to 8 percent for trimmed B-spline faces of screws, wings and fuselages. At 1e-6 the slowest
/// wing takes twice as long, and no volume changes by more than 1e-6.
constexpr double kAccuracy = 1e-5;

}  // namespace

double solid_content(const TopoDS_Shape& shape, const Progress* progress) {
    try {
        TopTools_IndexedMapOfShape solids;
        TopExp::MapShapes(shape, TopAbs_SOLID, solids);
        double sum = 0.0;
        for (int i = 1; i <= solids.Extent(); ++i) {
            check_cancelled(progress);
            const OpenCascadeWait wait(progress,
                                       Message::of(phrases::kMeasuringVolume, {{"name", "Solid" + std::to_string(i)}}));
            GProp_GProps properties;
            BRepGProp::VolumeProperties(solids(i), properties, kAccuracy);
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/placeholder_surfaces.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

namespace mq::geometry {

void add_placeholder_surfaces(const TopoDS_Shape& shape) {
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        const TopoDS_Face& face = TopoDS::Face(faces.Current());
        TopLoc_Location location;
        if (BRep_Tool::Surface(face, location).IsNull()) {
            const Handle(Geom_Surface) plane = new Geom_Plane(gp::XOY());
            const Handle(Geom_Surface) square = new Geom_RectangularTrimmedSurface(plane, 0.0, 1.0, 0.0, 1.0);
            BRep_Builder().UpdateFace(face, square, TopLoc_Location(), Precision::Confusion());
        }
    }
}

}  // namespace mq::geometry

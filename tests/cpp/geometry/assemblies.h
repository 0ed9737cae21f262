// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRep_Builder.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax1.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>
#include <vector>

/// Shapes of several solids for tests.
namespace mq::geometry {

inline TopoDS_Compound compound_of(const std::vector<TopoDS_Shape>& shapes) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes) {
        builder.Add(compound, shape);
    }
    return compound;
}

/// The same shape at another place: turned about an oblique axis by `angle` (radians), then moved along x.
inline TopoDS_Shape at_place(const TopoDS_Shape& shape, double x, double angle) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0.1, 0.2, 0.3), gp_Dir(1.0, 2.0, 3.0)), angle);
    gp_Trsf shift;
    shift.SetTranslation(gp_Vec(x, 0.0, 0.0));
    return shape.Moved(TopLoc_Location(shift * turn));
}

}  // namespace mq::geometry

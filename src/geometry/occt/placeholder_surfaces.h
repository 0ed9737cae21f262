// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

class TopoDS_Shape;

namespace mq::geometry {

/// Gives the faces of a shape that have triangles alone a surface too, in place: a square of 1 mm. FreeCAD copies
/// shapes for undoing, without their triangles, and a face with neither ends it when it is shown. From then on programs
/// may take the triangles away, as they can be made of a surface; so this is for a shape that is about to be replaced.
void add_placeholder_surfaces(const TopoDS_Shape& shape);

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gp_Mat.hxx>
#include <gp_Trsf.hxx>
#include <gp_XYZ.hxx>
#include <memory>

class TopoDS_Shape;

namespace mq::geometry {

/// The transformation with these rows, which are all that a stream keeps of its own: a scale within rounding of 1 or -1
/// is exactly that. gp_Trsf::SetValues, by which FreeCAD's placements are made, leaves it a last bit off in half of
/// them. The matrix must have an inverse.
gp_Trsf canonical_transformation(const gp_Mat& rows, const gp_XYZ& shift);

/// The shape with such transformations in all locations, so that it gives the same as a copy that came as a stream.
/// Where some differ, what has them is copied; all geometry is shared. The shape itself does not change.
std::shared_ptr<const TopoDS_Shape> with_canonical_locations(const TopoDS_Shape& shape);

}  // namespace mq::geometry

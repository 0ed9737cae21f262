// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

class TopoDS_Shape;

namespace mq::geometry {

/// Reads a shape from the binary BREP that FreeCAD's Part.Shape.exportBinary writes (OpenCASCADE's BinTools_ShapeSet of
/// version 3 or 4, then numbers of the shape, its location and its orientation). Sub-shapes keep their order, what they
/// share, their flags and tolerances, and all bits of their geometry, which OpenCASCADE's own reader does not.
/// @throws InvalidInput for anything else, and for a null shape
std::shared_ptr<const TopoDS_Shape> read_shape_stream(std::string_view bytes);

/// The shape in that form, without triangulations but those of faces that have no surface.
/// @throws InvalidInput for curves and surfaces that the form has not
std::string write_shape_stream(const TopoDS_Shape& shape);

/// Whether a shape was made by the same OpenCASCADE in memory that this core uses: shapes of another one, even of the
/// same version, must not be touched. Only the first word of the shape's data is read.
bool is_of_this_kernel(const TopoDS_Shape& vertex);

}  // namespace mq::geometry

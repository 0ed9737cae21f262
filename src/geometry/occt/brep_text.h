// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>

class TopoDS_Shape;

namespace mq::geometry {

/// Reads a shape from OpenCASCADE's BREP text. Sub-shapes keep their numbers.
/// @throws InvalidInput when the text holds no shape.
std::shared_ptr<const TopoDS_Shape> read_brep_text(const std::string& text);

/// The shape as BREP text, which reading the shape does not change: without triangulations, and without the marks that
/// making one leaves on faces and edges.
std::string write_brep_text(const TopoDS_Shape& shape);

/// Identifies the data of a shape: the same `tshape` means the very same topology in memory.
struct ShapeIdentity {
    std::size_t tshape = 0;  ///< address of the TShape
    int hash = 0;            ///< hash of TShape and location, as Part.Shape.hashCode()
};
ShapeIdentity identity_of(const TopoDS_Shape& shape);

}  // namespace mq::geometry

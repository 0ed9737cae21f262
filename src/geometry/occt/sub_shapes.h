// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <memory>

class TopoDS_Shape;

namespace mq::geometry {

/// A shared handle of the shape, which may outlive the argument.
std::shared_ptr<const TopoDS_Shape> kept(const TopoDS_Shape& shape);

std::size_t face_count(const TopoDS_Shape& shape);

/// A copy of a face of a shape, by its index: changes of the copy do not affect the shape.
std::shared_ptr<const TopoDS_Shape> copied_face(const TopoDS_Shape& shape, std::size_t face);

}  // namespace mq::geometry

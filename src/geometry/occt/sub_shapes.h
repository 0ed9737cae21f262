// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <memory>

class TopoDS_Shape;

namespace mq::geometry {

/// The same shape, to be kept.
std::shared_ptr<const TopoDS_Shape> kept(const TopoDS_Shape& shape);

std::size_t face_count(const TopoDS_Shape& shape);

/// A copy of a face of a shape, by its index: what is made of it does not change the shape.
std::shared_ptr<const TopoDS_Shape> copied_face(const TopoDS_Shape& shape, std::size_t face);

}  // namespace mq::geometry

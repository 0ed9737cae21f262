// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

namespace mq::geometry {

/// Values of u (direction 0) or v inside a face along which it is to be cut: the normal jumps there by more than 10
/// degrees, or the line is a point in space. The time is negligible where the surface is smooth.
std::vector<double> crease_lines(const TopoDS_Face& face, int direction);

/// Whether the face has a crease line in either direction.
bool has_crease(const TopoDS_Face& face);

}  // namespace mq::geometry

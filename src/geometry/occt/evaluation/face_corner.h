// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <optional>

namespace mq::geometry {

/// The smallest angle of a face between its edges at a vertex, radians, as the shape has it: what the topology makes of
/// it does not matter. None where none of its edges ends there.
std::optional<double> smallest_corner(const TopoDS_Face& face, const TopoDS_Vertex& vertex);

}  // namespace mq::geometry

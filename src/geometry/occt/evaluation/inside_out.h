// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace mq::geometry {

/// Whether a proof says that the faces of a solid look outward: a ray that leaves a face on its outer side meets no
/// other one. False says nothing.
/// @param solid  closed, with valid faces
bool looks_outward(const TopoDS_Shape& solid);

/// Whether the faces of a solid look inward, as OpenCASCADE says: the solid would be a hole in infinite space.
/// @param solid  without location
bool is_inside_out(const TopoDS_Shape& solid);

}  // namespace mq::geometry

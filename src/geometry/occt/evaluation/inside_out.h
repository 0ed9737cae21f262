// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace mq::geometry {

/// Whether a proof shows that the faces of a solid look outward: a ray that leaves a face on its outer side meets no
/// other face. False decides nothing, also if OpenCASCADE fails.
/// The ray ends far outside, so that the side on which it starts is the outer one; all faces have the same orientation,
/// so that one of them decides for all. That needs faces which the ray cannot miss: closed, without gaps, each of them
/// valid.
/// @param solid  in whose faces and shells OpenCASCADE's checks find no fault. Loose faces that were joined may have
/// gaps and cross each other: rays from different faces can contradict, and the sign of their volume decides.
bool looks_outward(const TopoDS_Shape& solid);

/// Whether the faces of a solid look inward, as OpenCASCADE says: the solid would be a hole in infinite space.
/// @param solid  without location
bool is_inside_out(const TopoDS_Shape& solid);

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "mesh/triangle_mesh.h"
#include "offset/trimmed/trimmed_offset.h"

namespace mq::offset {

/// The boundary of all points within a distance of a solid; for a negative distance, of those of its points that are
/// farther than that from its surface. Sharp edges are rounded on the outer side and kept on the inner one, as in the
/// exact offset.
///
/// The contour of the distance (contour) in a lattice that is divided until both sides of the contour are proven
/// (refine), and whose edges are collapsed as far as the tolerance allows (simplify).
/// @param solid  closed, oriented outward, without self-intersections, as the results of boolean() are. Borders between
/// its CAD faces are kept.
/// @throws InvalidInput for an option out of range, or if the cells would not fit into memory
/// @throws TopologyError if the result cannot be held in single precision
/// @throws Cancelled
OffsetResult contoured_offset(const mesh::TriangleMesh& solid, const OffsetOptions& options, Progress& progress);

/// The boundary of all points within a distance of some triangles of a surface, on both of their sides.
/// @param left_out  for each triangle whether it is left out; the surface may be open along these triangles
/// @throws as contoured_offset(); InvalidInput if all triangles are left out or the distance is below 0
OffsetResult contoured_walls(const mesh::TriangleMesh& surface, const std::vector<char>& left_out,
                             const OffsetOptions& options, Progress& progress);

}  // namespace mq::offset

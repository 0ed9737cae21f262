// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/offset/offset.h"
#include "mesh/triangle_mesh.h"

namespace mq::offset {

/// The boundary of all points within a distance of a solid, or of those of its points that are farther than that from
/// its surface: sharp edges are rounded on the outer side and kept on the inner one, as the exact offset has them.
///
/// The contour of the distance (contour) in a lattice that is divided until both sides of it are proven (refine), with
/// edges collapsed as far as the tolerance allows (simplify).
/// @param solid  closed, oriented outward, without self-intersections: what boolean() gives. Borders between
///     its CAD faces are kept.
/// @throws InvalidInput for an option out of range, and where the cells would not fit into memory
/// @throws TopologyError where the result cannot be held in single precision
/// @throws Cancelled
boolean::OffsetResult contoured_offset(const mesh::TriangleMesh& solid, const boolean::OffsetOptions& options,
                                       Progress& progress);

/// The boundary of all points within a distance of some triangles of a surface, on both of their sides.
/// @param left_out  for each triangle of the surface, which may be open where they are left out
/// @throws as contoured_offset; InvalidInput where all triangles are left out, and for a distance below 0
boolean::OffsetResult contoured_walls(const mesh::TriangleMesh& surface, const std::vector<char>& left_out,
                                      const boolean::OffsetOptions& options, Progress& progress);

}  // namespace mq::offset

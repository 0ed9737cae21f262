// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "layered_depth/reconstruction/directed_edge_set.h"
#include "layered_depth/reconstruction/octree.h"

namespace mq::layered_depth {

/// The surface under construction: points, and triangles with their source (-1: reconstructed).
struct ContouredSurface {
    std::vector<mesh::Triangle> triangles;
    std::vector<std::int32_t> vertices;  ///< by sheet of the octree: its vertex; -1: no face needs one
    EdgeSet edges;            ///< edges of `triangles`, and edges between border vertices of the retained surface
    std::size_t refused = 0;  ///< triangles not made because an edge would have had a third
};

/// Contours the octree's leaves with IR-samples (Wang 2010, section III-B): one vertex for each sheet, one face for
/// each sign-changing minimal edge with an IR-sample.
///
/// All cells around such an edge contain that sample, so they are reconstructed-interior or boundary cells (Remark 1).
/// An edge with a retained sample gets no face even if all its cells are boundary cells: the retained surface passes
/// there. Vertices of sheets off the border are appended to `surface.points`.
/// @param vertices of the octree's sheets; -1 if contouring makes the vertex, see stitch()
/// @throws Cancelled
ContouredSurface contour(const OperandSet& pair, const Octree& tree, const SampleGrid& grid,
                         const CombinedSet& combined, const std::vector<Retention>& fate,
                         std::vector<std::int32_t> vertices, RetainedSurface& surface, const Progress* progress);

}  // namespace mq::layered_depth

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "layered_depth/reconstruction/octree.h"

namespace mq::layered_depth {

/// The counts of the changes that the filters made to the border.
struct StitchCounts {
    std::size_t boundary_cells = 0;
    std::size_t complex_cells = 0;
    std::size_t split_edges = 0;
    std::size_t collapsed_nodes = 0;
    std::size_t moved_nodes = 0;
    std::size_t left_nodes = 0;  ///< border vertices in a cell that uses another border vertex
};

/// Makes the border of the retained surface fit the boundary cells of the octree (Wang 2010, section III-B), and gives
/// each of these cells its vertex on the border.
///
/// Simple cells take the shared vertex of their two border edges (Remark 2a), or split their one edge at the point
/// nearest to the minimiser (2b). Complex cells are amended first. *Edge-Split* puts a vertex into the middle of each
/// edge's section within the cell. *Node-Collapse* merges the border vertices of the cell unless an edge would get a
/// third triangle. *Node-Position* moves the merged vertex to the minimiser unless a triangle would turn over.
/// Triangles that change lose their source.
/// @return for each sheet of the octree the index of its vertex in `surface.points`; -1 for sheets off the border
std::vector<std::int32_t> stitch(const Octree& tree, const SampleGrid& grid, RetainedSurface& surface,
                                 StitchCounts& counts);

}  // namespace mq::layered_depth

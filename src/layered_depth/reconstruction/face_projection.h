// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "layered_depth/reconstruction/octree.h"
#include "layered_depth/samples/face_samples.h"

namespace mq::layered_depth {

/// The counts of projecting reconstructed vertices onto the faces of shapes.
struct FaceProjection {
    std::size_t moved =
        0;  ///< vertices that were put onto all faces with samples in their cell, or onto the nearest face
    std::size_t left = 0;       ///< vertices that stay: no such point is near enough, or the move would make a fault
    double largest_move = 0.0;  ///< mm
};

/// Puts the vertices that were made or moved onto the CAD faces that have samples in their cell: with two faces onto
/// the curve in which these meet, with three into the corner.
///
/// The minimiser of the quadratic error lies on the tangent planes: its distance from a curved face grows as the
/// squared distance between rays. So Newton's method solves for all faces at once, with the least displacement in each
/// step; of faces that meet smoothly only the one that contains the point is used. If the solution is farther than half
/// the distance between rays, the vertex is projected onto the nearest face alone. Vertices of unchanged triangles of
/// operands stay.
/// @param reconstructed  triangles that are not in `surface` yet
/// @param vertices       by sheet of the octree: its vertex in `surface.points`, or -1
/// @param origin         of the frame of the operands, mm
/// @throws Cancelled
FaceProjection project_onto_faces(RetainedSurface& surface, const std::vector<mesh::Triangle>& reconstructed,
                                  const Octree& tree, const std::vector<std::int32_t>& vertices, const OperandSet& pair,
                                  const SampleGrid& grid, const Vec3& origin, const std::vector<CadShape>& shapes,
                                  geometry::Engine& engine, const Progress* progress);

}  // namespace mq::layered_depth

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "boolean/layered_depth/reconstruction/octree.h"
#include "boolean/layered_depth/samples/face_samples.h"

namespace mq::boolean {

/// The counts of projecting reconstructed vertices onto the faces of shapes.
struct FaceProjection {
    std::size_t moved = 0;  ///< vertices that were put onto all faces with samples in their cell, or onto the nearest
    std::size_t left = 0;   ///< vertices without such a point near enough, or that would make a fault there
    double largest_move = 0.0;  ///< mm
};

/// Puts the vertices that were made or moved onto the CAD faces that have samples in their cell: one that has two on
/// the curve where these meet, one that has three into the corner.
///
/// The minimiser of the quadratic error is that of tangent planes, off a curved face by the square of the distance
/// between rays. Newton's method on all faces at once, with the least displacement each time; of faces that meet
/// smoothly the one that holds the point is taken. Where this leads farther than half the distance between rays, the
/// nearest face is. Vertices of triangles that are an operand's own stay.
/// @param reconstructed  triangles that are not in `surface` yet
/// @param vertices       of the octree's sheets in `surface.points`, or -1
/// @param origin         of the frame of the operands, mm
/// @throws Cancelled
FaceProjection project_onto_faces(RetainedSurface& surface, const std::vector<mesh::Triangle>& reconstructed,
                                  const Octree& tree, const std::vector<std::int32_t>& vertices, const OperandSet& pair,
                                  const SampleGrid& grid, const Vec3& origin, const std::vector<CadShape>& shapes,
                                  geometry::Engine& engine, const Progress* progress);

}  // namespace mq::boolean

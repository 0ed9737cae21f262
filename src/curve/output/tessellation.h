// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "curve/output/curved_mesh.h"
#include "mesh/triangle_mesh.h"

namespace mq::curve {

/// Flat triangles in place of curved ones, for viewers and for Mesh features.
struct Tessellation {
    mesh::TriangleMesh mesh;
    std::vector<std::int32_t> element;  ///< for each triangle of the mesh the curved triangle of which it is a piece
    /// The edges of the curved triangles, each once: runs of vertices of the mesh, every run followed by -1.
    std::vector<std::int32_t> edge_lines;
    /// Outward unit normals of the curved triangles at the vertices, and three of them by triangle of the mesh. Where
    /// two curved triangles meet at an angle a vertex has a normal for each.
    std::vector<Vec3> normals;
    std::vector<std::int32_t> triangle_normals;
    double deviation = 0.0;  ///< bound of the distance from the curved triangles, mm
};

/// Divides every curved triangle only where it bends: into chords and flat triangles from which its distance is at most
/// `deviation` (mm; 0: a thousandth of the mesh's size). The bound follows from the Bezier control points: a curve or
/// patch lies in their convex hull. A curved edge is divided once for the triangles on both of its sides, so that
/// closed surfaces stay closed. A deviation below the resolution of single precision is raised to it.
/// @throws InvalidInput when that takes more than `max_triangles`.
Tessellation tessellate(const CurvedMesh& mesh, double deviation, const Progress* progress = nullptr,
                        std::size_t max_triangles = 20'000'000);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "curve/curved_mesh.h"
#include "mesh/triangle_mesh.h"

namespace mq::curve {

/// Flat triangles in place of curved ones, for viewers and for Mesh features.
struct Tessellation {
    mesh::TriangleMesh mesh;
    std::vector<std::int32_t> element;  ///< by triangle of the mesh: the curved triangle that it is a part of
    /// The edges of the curved triangles, each once: runs of vertices of the mesh, every run followed by -1.
    std::vector<std::int32_t> edge_lines;
    /// Outward unit normals of the curved triangles at the vertices, and three of them by triangle of the mesh. Where
    /// two curved triangles meet at an angle a vertex has a normal for each.
    std::vector<Vec3> normals;
    std::vector<std::int32_t> triangle_normals;
    double deviation = 0.0;  ///< what the curved triangles keep within, mm
};

/// Cuts every curved triangle only where it bends: into chords and flat triangles from which it is nowhere further than
/// `deviation` (mm; 0: a thousandth of the mesh's size). That follows from the Bezier control points: a curve or patch
/// lies in their convex hull. A curved edge is divided once for the triangles on both of its sides, so that what was
/// closed stays closed. Less than what single precision resolves is not asked for.
/// @throws InvalidInput when that takes more than `max_triangles`.
Tessellation tessellate(const CurvedMesh& mesh, double deviation, const Progress* progress = nullptr,
                        std::size_t max_triangles = 20'000'000);

}  // namespace mq::curve

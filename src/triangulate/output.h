// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "geometry/topology.h"
#include "mesh/surface_mesh.h"
#include "mesh/triangle_mesh.h"

namespace mq::triangulate {

struct Output {
    mesh::TriangleMesh mesh;
    std::vector<int> source;  ///< triangle of the working mesh for each triangle
};

/// The mesh volume by volume: every solid, shell and set of free faces becomes an oriented manifold of its own.
///
/// Triangles share a vertex only where they are joined by edges with exactly two sides, so faces that merely touch
/// (two solids at a common edge, two cones at their tips, more than two faces at one edge) stay apart. A face shared
/// by two solids comes twice, once from each side. A closed volume that is inside out is turned.
/// @throws Cancelled when `progress` says so
Output write_out(const mesh::SurfaceMesh& mesh, const geometry::Topology& topology, const Vec3& origin,
                 const Progress& progress);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "geometry/topology.h"
#include "mesh/triangle_mesh.h"
#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

struct Output {
    mesh::TriangleMesh mesh;
    std::vector<int> source;  ///< by triangle of `mesh`: its triangle in the working mesh
};

/// Returns the mesh volume by volume: every solid, shell and set of free faces becomes an oriented manifold of its
/// own.
///
/// Triangles share a vertex only where they are joined by edges with exactly two sides, so that faces that merely
/// touch (two solids at a common edge, two cones at their tips, more than two faces at one edge) remain separated. A
/// face shared by two solids occurs twice, once for each side. A closed volume that is inside out is reversed.
/// @throws Cancelled when `progress` requests it
Output write_out(const ClassifiedMesh& mesh, const geometry::Topology& topology, const Vec3& origin,
                 const Progress& progress);

}  // namespace mq::triangulate

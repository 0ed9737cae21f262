// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Where the distance of a mesh from something is measured: all used vertices, the middles of all edges, and the
/// centroids of all triangles, in the part's frame. The mesh must be valid (see measure).
std::vector<Vec3> deviation_samples(const TriangleMesh& mesh);

}  // namespace mq::mesh

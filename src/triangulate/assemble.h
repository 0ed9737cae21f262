// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/initial_triangulation.h"
#include "mesh/surface_mesh.h"

namespace mq::triangulate {

/// Glues the faces of S_C into one mesh: vertices of the chains shared, pieces of CAD edges as segments.
mesh::SurfaceMesh assemble(const geometry::InitialTriangulation& initial, const geometry::Topology& topology);

}  // namespace mq::triangulate

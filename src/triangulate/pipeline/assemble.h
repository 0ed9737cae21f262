// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/initial/initial_triangulation.h"
#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Glues the faces of S_C into one mesh: faces share the vertices of the chains, and pieces of CAD edges are segments.
ClassifiedMesh assemble(const InitialTriangulation& initial, const geometry::Topology& topology);

}  // namespace mq::triangulate

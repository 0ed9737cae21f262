// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "curve/given/given_mesh.h"

namespace mq::curve {

/// Gives each body of a mesh of triangles nodes of its own, where bodies touch in nodes and edges.
///
/// Two triangles at an edge belong together. Where an edge has more, each body is the wedge between a triangle that is
/// seen from its front and one that is seen from its back, going round the edge; a wedge that begins first ends first,
/// as bodies that touch do not overlap. Edges whose triangles have no such order keep them together. Meshes with
/// tetrahedra stay as they are.
/// @return by node: the one that it is a copy of, or itself. The copies come after all nodes of before.
std::vector<int> separate_touching_bodies(GivenMesh& mesh);

}  // namespace mq::curve

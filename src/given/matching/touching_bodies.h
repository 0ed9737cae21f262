// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "given/matching/given_mesh.h"

namespace mq::given {

/// Gives each body of a mesh of triangles its own nodes if bodies touch in nodes and edges.
///
/// If an edge has two triangles, these belong to one body. If it has more, each body is the wedge between a triangle
/// seen from its front and one seen from its back, going round the edge; a wedge that begins first ends first, as
/// bodies that touch do not overlap. Bodies at an edge whose triangles have no such order stay joined. Meshes with
/// tetrahedra stay as they are.
/// @return by node: the node that it is a copy of, or itself. The copies come after all given nodes.
std::vector<int> separate_touching_bodies(GivenMesh& mesh);

}  // namespace mq::given

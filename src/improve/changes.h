// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "improve/editable_mesh.h"

namespace mq::improve {

/// The changes that are possible; whether they are good is another matter. None where the mesh's connections or its
/// sharp edges forbid them.

/// Swaps the edge a-b of two triangles.
std::optional<Change> swap_edge(const EditableMesh& mesh, int a, int b);

/// Moves a vertex into a neighbour. `bend` (radians): by how much sharp edges may turn at a vertex that goes.
std::optional<Change> collapse_edge(const EditableMesh& mesh, int from, int to, double bend);

/// Puts a new vertex of the mesh, not used yet, on the edge a-b.
Change split_edge(const EditableMesh& mesh, int a, int b, int middle);

/// Puts a new vertex of the mesh, not used yet, in the place of another one.
Change replace_vertex(const EditableMesh& mesh, int v, int other);

/// Whether a vertex may move along the surface (no sharp edges), along its sharp edges (two, nearly straight), or not.
enum class Freedom { Surface, Curve, None };
Freedom freedom(const EditableMesh& mesh, int v, double bend);

}  // namespace mq::improve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "improve/editable_mesh.h"

namespace mq::improve {

/// The changes that are topologically possible; their quality is judged elsewhere. None where the mesh's connections or
/// its sharp edges forbid them.

/// Swaps the edge a-b of two triangles.
std::optional<LocalOperation> swap_edge(const EditableMesh& mesh, int a, int b);

/// Collapses a vertex into a neighbour.
/// @param bend largest turn of the sharp edges at the removed vertex, radians.
std::optional<LocalOperation> collapse_edge(const EditableMesh& mesh, int from, int to, double bend);

/// Puts a new vertex of the mesh, not used yet, on the edge a-b.
LocalOperation split_edge(const EditableMesh& mesh, int a, int b, int middle);

/// Replaces a vertex by a new vertex of the mesh, not used yet.
LocalOperation replace_vertex(const EditableMesh& mesh, int v, int other);

/// Whether a vertex may move along the surface (no sharp edges), along its sharp edges (two, nearly straight), or not.
enum class Freedom { Surface, Curve, None };
Freedom freedom(const EditableMesh& mesh, int v, double bend);

}  // namespace mq::improve

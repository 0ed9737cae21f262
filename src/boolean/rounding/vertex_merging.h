// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "boolean/extraction/result_mesh.h"

namespace mq::boolean {

/// Merges vertices that rounding has put in one place, and removes the triangles between them, where the surface stays
/// a manifold: around every vertex concerned its triangles are one closed fan of at least three. Other places are left
/// as they are.
/// @return whether any were merged
bool merge_coincident_vertices(ResultMesh& draft);

}  // namespace mq::boolean

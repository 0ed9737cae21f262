// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// For each triangle the patch to which it belongs, -1 where it belongs to none. A patch is a height field over a
/// coordinate plane, or the star of a vertex with more than 4096 triangles over another plane (see embedded_star): no
/// two of its triangles meet except in the vertices and edges they share.
///
/// Patches grow over edges of two triangles as long as the projection keeps their orientation. A patch is proven by its
/// border (compare Volino, Magnenat-Thalmann 1994): where the projected border consists of loops that are simple and
/// disjoint, and one of them alone runs counter-clockwise, it winds at most once around any point of the plane, so that
/// no point has two triangles above it. All tests are exact; triangles without a proof are in no patch. O(n), about 0.1
/// us a triangle. Every vertex index must be in range and every coordinate finite.
/// @param fewest  least number of triangles in a patch that is worth a proof
/// @throws Cancelled.
std::vector<std::int32_t> height_fields(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                                        std::size_t fewest, const Progress* progress = nullptr);

}  // namespace mq::mesh

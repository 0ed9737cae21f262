// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "boolean/arrangement/arrangement.h"

namespace mq::boolean {

/// How often each operand winds around the space just in front of a face.
struct RayWinding {
    std::int32_t face = -1;
    std::vector<std::int32_t> winding;
};

/// Shoots a ray along an axis from a point inside one of the faces, the largest that is usable, and counts the
/// triangles that it passes through, exactly. A ray that meets an edge or a vertex is replaced by another.
/// @return nothing when none of the largest faces has a point of double precision inside: the component has no volume
/// @throws TopologyError when no ray is usable
std::optional<RayWinding> winding_in_front(const Soup& soup, const Arrangement& arrangement,
                                           const std::vector<std::int32_t>& faces);

}  // namespace mq::boolean

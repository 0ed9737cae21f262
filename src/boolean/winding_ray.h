// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "boolean/arrangement.h"

namespace mq::boolean {

/// How often each operand winds around the space just in front of a face.
struct RayWinding {
    std::int32_t face = -1;
    std::vector<std::int32_t> winding;
};

/// Shoots a ray along an axis from a point inside one of the faces, the largest that serves, and counts the triangles
/// that it passes through, exactly. A ray that meets an edge or a vertex is replaced by another.
/// @throws TopologyError when no ray serves
RayWinding winding_in_front(const Soup& soup, const Arrangement& arrangement, const std::vector<std::int32_t>& faces);

}  // namespace mq::boolean

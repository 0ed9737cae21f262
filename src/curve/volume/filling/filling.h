// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "base/key_set.h"
#include "base/vec.h"

namespace mq::curve {

/// A surface that cannot be filled, mostly because it intersects itself: a finer one may be filled.
class MeshingFailed : public GeometryError {
    using GeometryError::GeometryError;
};

/// Tangents of the curved edges of a surface at their ends, by directed edge: at the first vertex, towards the second.
using EndTangents = std::unordered_map<std::uint64_t, Vec3>;

inline std::uint64_t directed_edge(int from, int to) {
    return ordered_key(static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to));
}

/// Tetrahedra inside a closed surface.
struct TetrahedralFilling {
    std::vector<Vec3> inner_points;              ///< numbered after the points of the surface
    std::vector<std::array<int, 4>> tetrahedra;  ///< positive volume
    std::string own_fault;                       ///< why Netgen has made it, see fill(); empty for ours
};

}  // namespace mq::curve

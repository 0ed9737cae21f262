// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <unordered_map>

#include "base/key_set.h"
#include "base/vec.h"

namespace mq::tetrahedralise {

/// Tangents of the curved edges of a surface at their ends, by directed edge: at the first vertex, towards the second.
using EndTangents = std::unordered_map<std::uint64_t, Vec3>;

inline std::uint64_t directed_edge(int from, int to) {
    return ordered_key(static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to));
}

}  // namespace mq::tetrahedralise

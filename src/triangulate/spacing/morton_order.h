// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace mq::triangulate {

/// Returns the place of a point of the unit square along a curve that visits near points soon after each other (Morton
/// 1966).
inline std::uint32_t morton_order(const Vec2& unit) {
    constexpr double kLargestCoordinate = 65535.0;  // Largest 16-bit number: two of them are interleaved in 32 bits.
    const auto x = static_cast<std::uint32_t>(unit.x() * kLargestCoordinate);
    const auto y = static_cast<std::uint32_t>(unit.y() * kLargestCoordinate);
    std::uint32_t place = 0;
    for (unsigned bit = 0; bit < 16; ++bit) {
        place |= (((x >> bit) & 1U) << (2 * bit)) | (((y >> bit) & 1U) << (2 * bit + 1));
    }
    return place;
}

}  // namespace mq::triangulate

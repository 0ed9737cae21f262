// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

namespace mq::view {

/// Red, green, blue, opacity.
using Colour = std::array<std::uint8_t, 4>;

/// The colour in Coin's packed form.
inline std::uint32_t packed(const Colour& c) {
    return std::uint32_t{c[0]} << 24 | std::uint32_t{c[1]} << 16 | std::uint32_t{c[2]} << 8 | std::uint32_t{c[3]};
}

}  // namespace mq::view

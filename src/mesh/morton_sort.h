// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "base/memory/large_vector.h"

namespace mq::mesh {

/// Cells along a side of the grid of Morton codes.
constexpr std::uint32_t kMortonCells = 1024;

/// Returns the place of a cell along a curve through the grid that visits near cells soon after each other (Morton
/// 1966). Coordinates below 0, and those that are no numbers, count as 0; others must be below kMortonCells.
std::uint32_t morton_code(const std::array<double, 3>& cell);

/// An item's Morton code.
struct MortonKey {
    std::uint32_t code;
    std::uint32_t item;
};

/// Sorts by code; items with equal codes keep their order. O(n).
void sort_by_code(LargeVector<MortonKey>& keys);

}  // namespace mq::mesh

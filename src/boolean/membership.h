// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "boolean/combine.h"

namespace mq::boolean {

/// What becomes of a triangle of the operands.
enum class Fate : std::uint8_t { Removed, Kept, KeptReversed };

/// Which triangles stay (Wang 2010, section II, step 3): a region stays iff all its samples are samples of the result,
/// all with the same side out, and no triangle of it touches a region that does not.
/// @param samples of each triangle, see count_samples
/// @param region of each triangle, see cluster
std::vector<Fate> classify(const OperandPair& pair, const std::vector<std::uint32_t>& samples,
                           const std::vector<std::int32_t>& region, const CombinedSet& combined);

}  // namespace mq::boolean

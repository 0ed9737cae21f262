// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "boolean/layered_depth/samples/combine_samples.h"

namespace mq::boolean {

/// Whether a triangle of the operands stays.
enum class Retention : std::uint8_t { Removed, Kept, KeptReversed };

/// Which triangles stay (Wang 2010, section II, step 3): a region stays iff all its samples are samples of the result,
/// all with the same side out, and no triangle of it touches a region that does not, or the border of an open operand.
/// @param samples number for each triangle, see count_samples
/// @param region for each triangle, see cluster
std::vector<Retention> classify(const OperandSet& pair, const std::vector<std::uint32_t>& samples,
                                const std::vector<std::int32_t>& region, const CombinedSet& combined);

}  // namespace mq::boolean

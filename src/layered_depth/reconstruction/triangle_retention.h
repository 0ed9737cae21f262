// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "layered_depth/samples/combine_samples.h"

namespace mq::layered_depth {

/// Whether a triangle of the operands is retained.
enum class Retention : std::uint8_t { Removed, Kept, KeptReversed };

/// Decides which triangles are retained (Wang 2010, section II, step 3). A region is retained iff all its samples are
/// samples of the result, all of them have the same side outward, and no triangle of it touches a region that is not
/// retained or the border of an open operand.
/// @param samples number of samples of each triangle, see count_samples()
/// @param region of each triangle, see cluster()
std::vector<Retention> classify(const OperandSet& pair, const std::vector<std::uint32_t>& samples,
                                const std::vector<std::int32_t>& region, const CombinedSet& combined);

}  // namespace mq::layered_depth

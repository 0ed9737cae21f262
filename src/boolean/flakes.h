// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>

#include "boolean/draft.h"

namespace mq::boolean {

/// Marks as gone the components of some triangles that are flakes: thinner on average than `thinnest` (mm).
/// @return how many
std::size_t remove_flakes(Draft& draft, const std::set<std::int32_t>& faults, double thinnest);

}  // namespace mq::boolean

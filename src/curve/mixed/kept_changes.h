// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "base/vec.h"
#include "curve/mixed/node_relaxation.h"

namespace mq::curve {

/// Undoes changes of nodes that did not help. Elements with changed nodes that are connected by these belong together:
/// where no fewer of them are invalid than before, all of their nodes go back.
/// @param before          where the nodes were
/// @param quality_before  by element, and `quality` after the changes: not positive is invalid
/// @return the elements whose nodes stay changed
std::set<std::size_t> keep_what_helps(const std::vector<ElementNodes>& elements, const std::vector<Vec3>& before,
                                      const std::vector<double>& quality_before, const std::vector<double>& quality,
                                      std::vector<Vec3>& nodes);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "base/vec.h"
#include "given/mixed/node_relaxation.h"

namespace mq::given {

/// Undoes changes of nodes that made no fewer elements invalid. Elements with changed nodes form groups that are
/// connected by these nodes: if a group has no fewer invalid elements than before, all of its nodes go back.
/// @param before          positions of the nodes before the changes
/// @param quality_before  by element, and `quality` after the changes; not positive: invalid
/// @return the elements whose nodes stay changed
std::set<std::size_t> revert_unhelpful_moves(const std::vector<ElementNodes>& elements, const std::vector<Vec3>& before,
                                             const std::vector<double>& quality_before,
                                             const std::vector<double>& quality, std::vector<Vec3>& nodes);

}  // namespace mq::given

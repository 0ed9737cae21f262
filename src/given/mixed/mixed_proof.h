// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "given/mixed/node_relaxation.h"

namespace mq::given {

/// Sets by element the proven lower bound of min J / max |J|; not positive: not proven valid.
/// @param only  the elements to examine; all others keep their entries in `bounds`
void prove_mixed(const std::vector<ElementNodes>& elements, int order, const std::vector<Vec3>& nodes,
                 const std::vector<std::size_t>& only, std::vector<double>& bounds, Progress& progress);

/// The volume of solid elements, mm^3.
double volume_of(const std::vector<ElementNodes>& elements, int order, const std::vector<Vec3>& nodes);

}  // namespace mq::given

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "boolean/arrangement.h"
#include "boolean/cells.h"
#include "boolean/draft.h"
#include "boolean/operation.h"

namespace mq::boolean {

/// The faces between what belongs to the result and what does not, turned outward.
///
/// Where parts of the result touch in an edge or a vertex only, each part gets its own copy of it (Node-Open, Wang
/// 2010, section IV.C): the faces around an edge are joined across the material between them. The copies lie in one
/// place until they are parted.
struct Extraction {
    Draft draft;
    /// Vertices of the draft in the same place, the lowest index first.
    std::vector<std::vector<std::int32_t>> copies;
};

Extraction extract(const Soup& soup, const Arrangement& arrangement, const Cells& cells, Operation operation,
                   const Progress& progress);

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "boolean/arrangement/arrangement.h"
#include "boolean/arrangement/cells.h"
#include "boolean/extraction/result_mesh.h"
#include "boolean/input/operation.h"

namespace mq::boolean {

/// The faces between the result's inside and its outside, oriented outward.
///
/// Where regions of the result touch in an edge or a vertex only, each region gets its own copy of it (Node-Open, Wang
/// 2010, section IV.C): the faces around an edge are joined across the material between them. The copies lie in one
/// place until they are separated.
struct Extraction {
    ResultMesh draft;
    /// Vertices of the draft in the same place, the lowest index first.
    std::vector<std::vector<std::int32_t>> copies;
};

Extraction extract(const Soup& soup, const Arrangement& arrangement, const Cells& cells, const Expression& expression,
                   const Progress& progress);

}  // namespace mq::boolean

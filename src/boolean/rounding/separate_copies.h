// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "boolean/extraction/extraction.h"

namespace mq::boolean {

/// Separates regions of the result that touch in points: moves all but the first copy of each such point into the
/// material of its region, against the normals there or, in a thin wedge, whose normals cancel each other, along the
/// edges of the wedge. The triangles at moved copies lose their source.
///
/// @param distance  mm; a copy moves less where its shortest edge is below ten times that
/// @param least     mm; no copy moves less than this
/// @return the number of copies moved
std::size_t separate_copies(Extraction& extraction, double distance, double least);

}  // namespace mq::boolean

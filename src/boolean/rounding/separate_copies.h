// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "boolean/extraction/extraction.h"

namespace mq::boolean {

/// Moves all but the first copy of each point in which regions of the result touch into their own material, so that the
/// regions no longer touch: against the normals around them or, in a thin wedge, whose normals cancel each other, along
/// its edges, which cuts its tip off. The triangles around them are then no operand's own.
///
/// @param distance  mm; a copy moves less where its shortest edge is below ten times that
/// @param least     mm; no copy moves less than this
/// @return the number of copies moved
std::size_t separate_copies(Extraction& extraction, double distance, double least);

}  // namespace mq::boolean

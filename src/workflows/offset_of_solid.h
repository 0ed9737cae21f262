// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/offset/offset.h"
#include "workflows/boolean_of_operands.h"

namespace mq::workflows {

/// The offset of a solid (boolean::offset) with its report.
/// @param solid  the union of one operand, as boolean_of_operands gives it
/// @param operand  that operand, whose CAD faces the result's triangles are named by
/// @throws as boolean::offset
BooleanSurface offset_of_solid(const BooleanSurface& solid, const triangulate::Result& operand,
                               const boolean::OffsetOptions& options, const WorkBefore& before, Progress& progress);

/// All that is within a distance of some triangles of a solid (boolean::thicken) with its report.
/// @param left_out  for each triangle of the solid
/// @throws as boolean::thicken
BooleanSurface thickened_walls(const BooleanSurface& solid, const std::vector<char>& left_out,
                               const boolean::OffsetOptions& options, const WorkBefore& before, Progress& progress);

}  // namespace mq::workflows

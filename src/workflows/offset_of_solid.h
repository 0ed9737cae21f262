// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "offset/trimmed/trimmed_offset.h"
#include "workflows/boolean_of_operands.h"

namespace mq::workflows {

/// The offset of a solid with its report: boolean::offset, and where too many triangles of the raw offset cross for
/// that, or where it fails or misses the tolerance, offset::contoured_offset (its report has no crossing pairs).
/// @param solid  what boolean_of_operands gives; each triangle of the result is on the CAD face of the one from which
///     it is offset, where those are known (name_faces)
/// @throws as offset::contoured_offset
BooleanSurface offset_of_solid(const BooleanSurface& solid, const boolean::OffsetOptions& options,
                               const WorkBefore& before, Progress& progress);

/// What is deeper in a solid than a distance, from those of its triangles that are not open (boolean::extend_openings),
/// with its report and CAD faces likewise. It reaches out of the openings.
/// @param open  for each triangle of the solid
/// @param options  the distance is above 0
/// @return nothing where openings are not plane, or are in pockets that are too narrow
/// @throws as offset::contoured_offset
std::optional<BooleanSurface> hollow_beyond_openings(const BooleanSurface& solid, const std::vector<char>& open,
                                                     const boolean::OffsetOptions& options, const WorkBefore& before,
                                                     Progress& progress);

/// All that is within a distance of some triangles of a solid (boolean::thicken, offset::contoured_walls) with its
/// report and CAD faces likewise.
/// @param left_out  for each triangle of the solid
/// @throws as offset::contoured_walls
BooleanSurface thickened_walls(const BooleanSurface& solid, const std::vector<char>& left_out,
                               const boolean::OffsetOptions& options, const WorkBefore& before, Progress& progress);

}  // namespace mq::workflows

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "workflows/boolean_of_operands.h"

namespace mq::workflows {

struct OffsetShapeOptions {
    double distance = 0.0;   ///< mm: outward, inward if negative; of a hollow the thickness of its wall, above 0
    double tolerance = 0.0;  ///< mm; 0: see the functions
    int threads = 0;         ///< 0: one for each core
};

/// All points within a distance of a solid; for a negative distance, the points deeper in it than that. Meshing a
/// shape, the union of the operand's bodies, and the offset share the tolerance; its default is a thousandth of the
/// size of the result, at most a tenth of the distance.
/// @param solid  one operand: its bodies are united first, small faults repaired
/// @return with the faces of a shape; the error bound is proven and includes that of the mesh of the shape
/// @throws InvalidInput, TopologyError, Cancelled
BooleanSurface offset_shape(const Operands& solid, const OffsetShapeOptions& options, Progress& progress);

/// A solid of which only a wall is left: all of its points that are at most a thickness away from its surface. The
/// default of the tolerance is a fortieth of the thickness.
/// @param openings  faces of the shape that get no wall; nothing: the hollow is closed
/// @return triangle_source: (0, triangle of the united solid) for its whole triangles, (1, triangle) for those of the
///     hollow. The solid itself if it is nowhere thicker than twice the thickness.
/// @throws InvalidInput for openings of a mesh, or where all faces are open; TopologyError, Cancelled
BooleanSurface hollow_shape(const Operands& solid, const std::optional<std::vector<std::int32_t>>& openings,
                            OffsetShapeOptions options, Progress& progress);

}  // namespace mq::workflows

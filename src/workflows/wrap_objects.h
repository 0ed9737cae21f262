// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "workflows/boolean_of_operands.h"
#include "wrap/wrap.h"

namespace mq::workflows {

/// A wrap (wrap::wrap) of several objects, with its report: error_bound is the larger one of the measured distances.
struct WrapSurface : BooleanSurface {
    wrap::WrapDistance distance;
    std::vector<wrap::Leak> leaks;
    std::size_t gap_triangles = 0;
    double gap_area = 0.0;  ///< the sum of the triangles that close gaps, mm2
    /// The number of CAD faces of each object; 0: not all of its triangles have one, and it counts as one face.
    std::vector<std::int32_t> faces;
};

/// Wraps objects in any frames; shapes are meshed within a twentieth of the tolerance. `triangle_source` names the
/// object and its triangle on which each triangle lies, (-1, -1) where it closes a gap; in `triangle_face` the faces of
/// all objects are numbered consecutively. Triangles come by face, those of gaps first.
/// @param options  its places to stay dry are in the frame of the document; spacing 0: a quarter of the gap, at most a
///     fiftieth of the size
/// @throws InvalidInput where the spacing is more than half of the gap; as Operands::meshed and wrap::wrap
WrapSurface wrap_objects(const Operands& objects, wrap::WrapOptions options, Progress& progress);

}  // namespace mq::workflows

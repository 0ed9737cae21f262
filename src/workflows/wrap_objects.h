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
};

/// Wraps objects in any frames. `triangle_source` names the object and its triangle on which each triangle lies, (-1,
/// -1) where it closes a gap. Triangles come by face, those of gaps first.
/// @param faces  how many each object has: in `triangle_face` they are numbered on. A mesh that knows none has one
/// @param options  its places to stay dry are in the frame of the document
/// @throws as wrap::wrap
WrapSurface wrap_objects(const std::vector<BooleanOperand>& objects, const std::vector<std::int32_t>& faces,
                         const wrap::WrapOptions& options, const WorkBefore& before, Progress& progress);

}  // namespace mq::workflows

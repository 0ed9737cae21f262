// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Largest ratio of the angle between two CAD edges to the angle between their chords for which both angles count as
/// equal.
constexpr double kNarrowed = 1.08;

/// The angle between two CAD edges at a vertex.
struct EdgesAngle {
    double angle = 0.0;  ///< between their tangents, radians
    /// Where the curves end beside the vertex, within its tolerance: the angles that these gaps subtend at the chords'
    /// far ends, radians.
    double gaps = 0.0;
    double least() const { return angle > gaps ? angle - gaps : 0.0; }
};

/// Returns the angle between the CAD edges of two segments at a vertex where both end; no value if one has no direction
/// there.
std::optional<EdgesAngle> angle_between_edges(const Workspace& work, int a, int b, int vertex);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Up to so many times the angle between their chords two CAD edges count as enclosing the same.
constexpr double kNarrowed = 1.08;

/// The angle, radians, that the CAD edges of two segments enclose at a vertex where both end; no value where one has
/// no direction there.
std::optional<double> angle_between_edges(const Workspace& work, int a, int b, int vertex);

}  // namespace mq::triangulate

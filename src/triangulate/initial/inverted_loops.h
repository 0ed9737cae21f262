// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "geometry/oracle.h"
#include "triangulate/edges/edge_discretisation.h"
#include "triangulate/initial/face_boundary.h"

namespace mq::triangulate {

/// Returns pieces of the border that are too coarse: in every loop whose chords have another orientation in (u, v)
/// than its curves, the pieces that deviate most. Where both curves of a narrow loop bulge to the same side, and the
/// inner one has the finer chords, these lie beyond the chord of the outer one: nothing crosses, but each chord has
/// the face on its wrong side.
/// @param middles  see middles_of_pieces
std::vector<int> coarse_pieces_of_inverted_loops(geometry::Oracle& oracle, const EdgeDiscretisation& chains,
                                                 const FaceBoundary& border,
                                                 const std::vector<std::optional<Vec2>>& middles);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/edge_chains.h"
#include "geometry/face_border.h"
#include "geometry/session.h"

namespace mq::geometry {

/// Pieces of the border that are too coarse: those that deviate most of loops whose chords run around the other way in
/// (u, v) than their curves do. Where both curves of a narrow loop bulge to the same side, and the inner one has the
/// finer chords, these lie beyond the chord of the outer one: nothing crosses, but each has the face on its other side.
std::vector<int> coarse_pieces_of_inverted_loops(Session& session, const EdgeChains& chains, const FaceBorder& border);

}  // namespace mq::geometry

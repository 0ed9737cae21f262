// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/session.h"

namespace mq::geometry {

/// Of every face: a fingerprint of its geometry and of that of the edges and nodes around it, the same wherever the
/// face stands among the faces of its part, and wherever the part stands as a whole. Made of all numbers that define
/// the geometry, of the topology and the tolerances: nothing between is left out.
/// @throws Cancelled
std::vector<Fingerprint> keys_of_faces(Session& session);

/// Adds how the entities of a part are numbered, and where it stands: with the keys of all faces that is all of it.
void add_structure(Session& session, Fingerprint& key);

/// The uses of a face in the order of its loops: the same for two faces of the same key.
std::vector<int> uses_in_order(const Face& face);

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/session.h"

namespace mq::triangulate {

/// Returns, for every face, a fingerprint of its geometry and of that of its edges and nodes, independent of the
/// face's number in the shape and of the placement of the whole shape. It covers all numbers that define the geometry,
/// the topology and the tolerances.
/// @throws Cancelled
std::vector<geometry::Fingerprint> face_fingerprints(geometry::Session& session);

/// Adds the numbering of a shape's entities and its placement; with the keys of all faces this identifies the shape.
void add_structure(geometry::Session& session, geometry::Fingerprint& key);

}  // namespace mq::triangulate

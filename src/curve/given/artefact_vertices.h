// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/session.h"

namespace mq::curve {

/// Whether an edge lies between two sides of one face, whose surface is cut there for its parameters.
bool is_seam(const geometry::Topology& topology, const geometry::Edge& edge);

/// By CAD vertex, whether it is there for the parametrisation alone: seams meet there, and at most one closed edge that
/// begins and ends with the same tangent. Meshes need no vertex at it.
std::vector<char> artefact_vertices(geometry::Session& session);

}  // namespace mq::curve

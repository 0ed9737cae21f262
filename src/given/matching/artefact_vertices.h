// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/session.h"

namespace mq::given {

/// Whether an edge joins two sides of one face: the seam at which the parameters of a closed surface begin and end.
bool is_seam(const geometry::Topology& topology, const geometry::Edge& edge);

/// By CAD vertex, whether it exists for the parametrisation alone: seams meet in it, and at most one closed edge that
/// begins and ends with the same tangent. A mesh needs no vertex there.
std::vector<char> artefact_vertices(geometry::Session& session);

}  // namespace mq::given

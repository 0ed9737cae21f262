// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "geometry/edge_chains.h"
#include "geometry/face_triangulation.h"

namespace mq::geometry {

/// The structure S_C (Aftosmis 1999, eq. 2): a coarse triangulation of every face over shared edge chains. Glued by
/// topology, never by coordinates; every triangle turns less than 60 degrees away from its surface.
struct InitialTriangulation {
    EdgeChains chains;
    std::vector<FaceTriangulation> faces;
    std::vector<std::pair<int, std::string>> failures;  ///< faces without a triangulation, and why
};

InitialTriangulation triangulate_initially(Session& session, const SingleGrid& grid, Progress& progress);

}  // namespace mq::geometry

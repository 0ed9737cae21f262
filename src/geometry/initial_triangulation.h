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

/// Triangulates the other faces where some have their triangles over the chains already. These stay as they are unless
/// a piece of their border must be halved for a face beside them: then they are triangulated anew.
InitialTriangulation triangulate_the_rest(Session& session, const SingleGrid& grid, InitialTriangulation begun,
                                          Progress& progress);

}  // namespace mq::geometry

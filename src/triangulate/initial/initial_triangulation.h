// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "triangulate/edges/edge_discretisation.h"
#include "triangulate/initial/face_triangulator.h"

namespace mq::triangulate {

/// The structure S_C (Aftosmis 1999, eq. 2): a coarse triangulation of every face over shared edge chains. Faces are
/// glued by topology, never by coordinates; the normal of every triangle deviates less than 60 degrees from its
/// surface.
struct InitialTriangulation {
    EdgeDiscretisation chains;
    std::vector<FaceMesh> faces;
    std::vector<std::pair<int, std::string>> failures;  ///< faces without a triangulation, and the reasons
};

/// Edges that were contracted at a face which cannot be triangulated then are kept, and all begins again.
InitialTriangulation triangulate_initially(geometry::Session& session, const SinglePrecisionGrid& grid,
                                           Progress& progress);

/// Triangulates the faces that have no triangles yet. Faces with triangles remain as they are unless a piece of their
/// border must be halved for a neighbouring face: then they are triangulated again.
InitialTriangulation triangulate_the_rest(geometry::Session& session, const SinglePrecisionGrid& grid,
                                          InitialTriangulation begun, Progress& progress);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/initial_triangulation.h"
#include "triangulate/triangulate.h"

namespace mq::triangulate {

/// A triangulation of every face over samples whose density follows the curvature.
struct SampledTriangulation {
    geometry::InitialTriangulation faces;
    /// Faces whose pseudo-Delaunay triangulation was not taken, and why.
    std::vector<std::pair<int, std::string>> fallbacks;
    bool complete = true;  ///< false: max_triangles ended the sampling
};

/// Sampling after Ruiz et al.: edges first, then every face by the Star or the Sprinkle algorithm, then the
/// connectivity. `coarse` is the part's initial triangulation and `chord` the chord height in mm, 0: no bound. Faces
/// that the coarse triangulation lacks are left out and named as there.
SampledTriangulation sample_part(geometry::Session& session, const SingleGrid& grid, const Options& options,
                                 double chord, geometry::InitialTriangulation coarse, Progress& progress);

}  // namespace mq::triangulate

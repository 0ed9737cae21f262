// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "triangulate/initial/initial_triangulation.h"
#include "triangulate/work_mesh/options.h"

namespace mq::triangulate {

/// A triangulation of every face over samples whose density follows the curvature.
struct SampledTriangulation {
    InitialTriangulation faces;
    /// Faces whose pseudo-Delaunay triangulation was rejected, and the reasons.
    std::vector<std::pair<int, std::string>> fallbacks;
    bool complete = true;  ///< false: max_triangles stopped the sampling
};

/// Sampling after Ruiz et al.: edges first, then every face by the Star or the Sprinkle algorithm, then the
/// connectivity. `coarse` is the shape's initial triangulation and `chord` the chord tolerance in mm, 0: no bound.
/// Faces without a coarse triangulation are omitted, with the failures named there.
SampledTriangulation sample_shape(geometry::Session& session, const SinglePrecisionGrid& grid,
                                  const TriangulateOptions& options, double chord, InitialTriangulation coarse,
                                  Progress& progress);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/progress.h"
#include "triangulate/work_mesh/result.h"

namespace mq::workflows {

struct SimplifyOptions {
    double tolerance = 0.0;       ///< mm: largest distance between the two surfaces, both ways
    double feature_angle = 35.0;  ///< degrees: edges where the surface turns by more than this stay edges
};

/// A mesh with fewer triangles, measured, and how far it is from the given one.
struct SimplifiedSurface {
    triangulate::Result surface;
    double deviation = 0.0;  ///< mm: bound of the distance of all points of each surface from the other one, proven
    int rounds = 0;          ///< attempts until that was within the tolerance
};

/// Collapses edges of a mesh without CAD, as contour::simplify does, as long as the given vertices are within the
/// tolerance of the moved triangles, and sample points of these of the given surface. Then all points of both surfaces
/// are proven to be within it of the other one. Places for which that fails are kept near like the vertices, or in the
/// end the given triangles around them are fixed, and it begins anew.
///
/// The result has the topology of the given mesh, is closed where that is, and none of its triangles meet but those
/// that did; the triangles at open borders stay.
/// @throws InvalidInput for a mesh that is not manifold and oriented, naming the remedy; Cancelled
SimplifiedSurface simplify_surface(const mesh::TriangleMesh& given, const SimplifyOptions& options, Progress& progress);

}  // namespace mq::workflows

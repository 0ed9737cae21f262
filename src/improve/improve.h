// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "mesh/quality/exempt_reason.h"
#include "mesh/triangle_mesh.h"

namespace mq::improve {

struct ImproveOptions {
    double min_angle = 25.0;  ///< degrees: required smallest angle of every triangle, 0 < a <= 34
    double tolerance = 0.0;   ///< mm: largest distance between the surfaces; 0: 1e-3 of the largest dimension
    /// degrees: edges between triangles whose normals differ by more than this stay, 0 < a <= 180.
    double feature_angle = 35.0;

    /// @throws InvalidInput naming the option, its value and its range.
    void validate() const;
};

struct Result {
    mesh::TriangleMesh mesh;  ///< every coordinate a single-precision number
    std::size_t flips = 0;
    std::size_t collapses = 0;
    std::size_t splits = 0;
    std::size_t moves = 0;
    /// Triangles around which the given mesh was kept, as the improved triangles would cross or have an angle smaller
    /// than any given one.
    std::size_t kept = 0;
    /// Triangle, and the reason why its smallest angle is below `min_angle`.
    std::vector<std::pair<std::int32_t, mesh::ExemptReason>> exempt;
    StageTimes seconds;
};

/// Improves the triangles of a mesh without CAD geometry, on its own surface.
///
/// Bad triangles are improved worst first: an edge is swapped, a short edge collapsed, a vertex moved along the
/// surface; where that does not help, the terminal edge of the longest-edge path is halved (Rivara 1997,
/// LEPP-Delaunay). Swaps, collapses and moves are made only if the worst angle around becomes better. A change is
/// refused if it
/// - moves the corners, edge middles and centres of new triangles farther than the tolerance from the given surface, or
///   a given vertex farther than that from the new one,
/// - makes the angle between a triangle's normal and that of the surface larger than 60 degrees,
/// - removes a sharp edge (see ImproveOptions::feature_angle), a border, or an edge of more than two triangles;
/// vertices on
///   them move along them only, and stay where these meet or bend.
/// The connections of the given mesh are kept; it need not be closed. The result has no more degenerate triangles,
/// pinched vertices, vertices in one place and pairs of triangles that meet than the given mesh, no smaller angle, and
/// none of these points farther than the tolerance, also on halves of triangles: it is verified, and where it fails
/// improved again with that place left as it was given. Deterministic.
/// @throws InvalidInput for an option out of range, or a mesh with a triangle that names a vertex twice
/// @throws Cancelled
Result improve(const mesh::TriangleMesh& given, const ImproveOptions& options, Progress* progress = nullptr);

}  // namespace mq::improve

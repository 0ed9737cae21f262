// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/stage_clock.h"
#include "mesh/triangle_mesh.h"

namespace mq::improve {

struct Options {
    double min_angle = 25.0;      ///< degrees: what every triangle's smallest angle is to reach, 0 < a <= 34
    double tolerance = 0.0;       ///< mm: how far the surfaces may be from each other; 0: 1e-3 of the largest dimension
    double feature_angle = 35.0;  ///< degrees: edges where the surface turns by more than this stay, 0 < a <= 180

    /// @throws InvalidInput naming the option, its value and its range.
    void validate() const;
};

struct Result {
    mesh::TriangleMesh mesh;  ///< every coordinate a single-precision number
    std::size_t flips = 0;
    std::size_t collapses = 0;
    std::size_t splits = 0;
    std::size_t moves = 0;
    /// Triangle and why it is below the angle asked for.
    std::vector<std::pair<std::int32_t, std::string>> exempt;
    StageTimes seconds;
};

/// Improves the triangles of a mesh that has no CAD behind it, on the surface that it is.
///
/// Bad triangles are mended worst first: an edge is swapped, a short edge collapsed, a vertex moved along the surface;
/// where that does not help, the terminal edge of the longest-edge path is halved (Rivara 1997, LEPP-Delaunay). Swaps,
/// collapses and moves are done only if the worst angle around becomes better. Nothing is done that
/// - moves the corners, edge middles and centres of new triangles farther than the tolerance from the given surface, or
///   a given vertex farther than that from the new one (halves of such triangles, which are on the same surface, may
///   show a little more),
/// - turns a triangle's normal by more than 60 degrees from that of the surface,
/// - removes a sharp edge (see Options::feature_angle), a border, or an edge of more than two triangles; vertices on
///   them move along them only, and stay where these meet or bend.
/// The connections of the given mesh are kept; it need not be closed. Deterministic.
/// @throws InvalidInput for an option out of range, or a mesh with a triangle that names a vertex twice
/// @throws Cancelled
Result improve(const mesh::TriangleMesh& given, const Options& options, Progress* progress = nullptr);

}  // namespace mq::improve

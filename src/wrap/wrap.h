// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "base/vec.h"
#include "mesh/triangle_mesh.h"
#include "wrap/measure/leak.h"
#include "wrap/measure/wrap_distance.h"

namespace mq::wrap {

struct WrapOptions {
    double gap = 0.0;       ///< mm: openings narrower than this are closed
    double spacing = 0.0;   ///< mm: side of the lattice's cubes, at most half of the gap
    std::vector<Vec3> dry;  ///< places that shall stay inside, in the frame of the input
    int threads = 0;        ///< number of threads; 0: one for each core

    /// @throws InvalidInput naming the option
    void validate() const;
};

/// A closed surface around the whole input.
struct WrapResult {
    mesh::TriangleMesh mesh;
    /// The triangle of the input on which each triangle lies; -1: it closes a gap.
    std::vector<std::int32_t> triangle_source;
    WrapDistance distance;
    std::vector<Leak> leaks;      ///< paths to the places that shall stay dry and do not
    std::size_t sheet_nodes = 0;  ///< nodes of the lattice beside material thinner than its resolution
    StageTimes seconds;
};

/// The outer surface of any triangles, also if they cross, leave openings or are oriented differently.
///
/// A ball as wide as the gap rolls over the input from outside (roll_ball). The surface between the region that it
/// covers and the rest lies on the input, with its edges, where the ball touches the input (contour), and closes the
/// openings that the ball cannot enter. It is closed, 2-manifold and free of self-intersections by construction.
///
/// Openings narrower than the gap are closed; those wider than the gap and three spacings are entered.
/// @throws InvalidInput for an option out of range, no triangles, or a lattice that takes too much memory
/// @throws Cancelled
WrapResult wrap(const mesh::TriangleMesh& input, const WrapOptions& options, Progress& progress);

}  // namespace mq::wrap

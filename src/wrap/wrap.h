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
    std::vector<Vec3> dry;  ///< places that are to stay inside, in the frame of the input
    int threads = 0;        ///< that work at a time; 0: one for each core

    /// @throws InvalidInput naming the option
    void validate() const;
};

/// A closed surface around everything that is given.
struct WrapResult {
    mesh::TriangleMesh mesh;
    /// The triangle of the input on which each triangle lies; -1 where it closes a gap.
    std::vector<std::int32_t> triangle_source;
    WrapDistance distance;
    std::vector<Leak> leaks;      ///< to the places that are to stay dry and do not
    std::size_t sheet_nodes = 0;  ///< nodes of the lattice beside material that is thinner than it resolves
    StageTimes seconds;
};

/// The outer surface of any triangles, however they cross, miss each other or are oriented.
///
/// A ball as wide as the gap rolls over the input from outside (mark_outside). The surface between what it covers and
/// the rest lies on the input where the ball touches that, with its edges (contour), and closes what the ball cannot
/// enter. It is closed, 2-manifold and free of self-intersections by construction.
///
/// Openings narrower than the gap are closed; those wider than the gap and three spacings are entered.
/// @throws InvalidInput for an option out of range, no triangles, or a lattice that takes too much memory
/// @throws Cancelled
WrapResult wrap(const mesh::TriangleMesh& input, const WrapOptions& options, Progress& progress);

}  // namespace mq::wrap

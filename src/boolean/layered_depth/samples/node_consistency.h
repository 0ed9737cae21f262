// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "boolean/layered_depth/samples/layered_depth_image.h"

namespace mq::boolean {

/// A sample by its place in a LayeredDepthSet.
struct SampleRef {
    int axis;
    std::uint32_t ray;
    std::uint32_t index;  ///< index among the samples of its axis
};

struct ConsistencyCounts {
    std::size_t nodes = 0;     ///< nodes of the grid at which the three rays did not agree
    std::size_t inserted = 0;  ///< samples that a ray had missed
    std::size_t removed = 0;   ///< samples of surfaces that a ray does not meet
    std::size_t left = 0;      ///< nodes at which the rays still do not agree
};

/// Puts the samples of every ray into ascending order once their depths have changed. Where an entry and an exit have
/// passed each other the ray misses the wedge between their faces: both vanish, so that every ray still leaves the
/// solid as often as it enters.
/// @return the samples that vanished
std::size_t restore_order(LayeredDepthImage& image);

/// Makes the rays of the three directions agree whether the nodes of the grid are inside.
///
/// A mesh tells which faces a ray meets. Where a ray grazes a curved face, the mesh may be met and the face missed or
/// the other way round, while a ray across meets both: then the node where they cross is inside for one and outside for
/// the other. The ray that meets the surface near the node most squarely decides, or two of the three; the others get
/// the samples that they missed, on the tangent plane of a sample of a neighbouring ray, or lose those too many. Each
/// ray keeps as many entries as exits.
/// @return the samples that were inserted
/// @throws Cancelled
std::vector<SampleRef> make_consistent(LayeredDepthSet& set, const SampleGrid& grid, ConsistencyCounts& counts,
                                       const Progress* progress);

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "layered_depth/samples/layered_depth_image.h"

namespace mq::layered_depth {

/// A sample by its position in a LayeredDepthSet.
struct SampleRef {
    int axis;
    std::uint32_t ray;
    std::uint32_t index;  ///< index among the samples of its axis
};

struct ConsistencyCounts {
    std::size_t nodes = 0;     ///< nodes of the grid at which the three rays did not agree
    std::size_t inserted = 0;  ///< samples that were missing on a ray
    std::size_t removed = 0;   ///< samples of surfaces that the ray does not meet
    std::size_t left = 0;      ///< nodes at which the rays still do not agree
};

/// Sorts the samples of every ray in ascending order after their depths have changed. If an entry and the exit after it
/// have changed places, the ray misses the wedge between their faces: both samples are removed, so that every ray still
/// leaves the solid as often as it enters it.
/// @return number of samples that were removed
std::size_t restore_order(LayeredDepthImage& image);

/// Makes the rays of the three directions agree whether each node of the grid is inside.
///
/// The mesh tells which faces a ray meets. If a ray grazes a curved face, it may meet the mesh and miss the face or the
/// other way round, while a ray across meets both: the node in which these rays cross is then inside for one and
/// outside for the other. The ray that meets the surface near the node most nearly at right angles decides, or else two
/// of the three rays. The other rays get the missing samples, on the tangent plane of a sample of a neighbouring ray,
/// or lose the surplus ones. Each ray keeps as many entries as exits.
/// @return the samples that were inserted
/// @throws Cancelled
std::vector<SampleRef> make_consistent(LayeredDepthSet& set, const SampleGrid& grid, ConsistencyCounts& counts,
                                       const Progress* progress);

}  // namespace mq::layered_depth

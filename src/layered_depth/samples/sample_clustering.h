// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "layered_depth/samples/layered_depth_image.h"

namespace mq::layered_depth {

/// Number of samples of each triangle of the operands.
std::vector<std::uint32_t> count_samples(const OperandSet& pair, const std::vector<LayeredDepthSet>& operands);

/// Marks the triangles that do not lie within the grid.
std::vector<std::uint8_t> triangles_beyond(const OperandSet& pair, const SampleGrid& grid);

/// Finds regions of the surface that have samples (Wang 2010, Fig. 3): a triangle that no ray meets joins a sampled
/// neighbour by flood fill, ring by ring over shared vertices.
///
/// @return for each triangle the sampled triangle that represents its region (itself if it is sampled); -1 in
/// components that no ray meets, and for triangles marked in `beyond`
std::vector<std::int32_t> cluster(const OperandSet& pair, const std::vector<std::uint32_t>& samples,
                                  const std::vector<std::uint8_t>& beyond);

}  // namespace mq::layered_depth

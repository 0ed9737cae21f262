// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "triangulate/face_sampler.h"

namespace mq::triangulate {

/// The Sprinkle algorithm (Ruiz et al., section 2.3): random points of the face, kept where the ball of radius r(K)
/// around them holds no sample yet.
///
/// The paper throws darts evenly in (u, v) until 1000 fail one after the other. Here they are thrown into the gaps
/// between the balls, in cells of the face about as large as the balls, until none is left: the density of darts
/// follows the surface in space instead of its parameters, no gap is left over, and the time is linear in the samples.
/// The same seed gives the same samples.
std::vector<FaceSampler::Candidate> sample_sprinkle(const SamplingContext& context, int face,
                                                    const geometry::FaceBorder& border, std::uint64_t seed);

}  // namespace mq::triangulate

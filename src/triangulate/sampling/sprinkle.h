// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "triangulate/sampling/face_sampler.h"

namespace mq::triangulate {

/// The Sprinkle algorithm (Ruiz et al., section 2.3): random points of the face, kept if the ball of radius r(K)
/// around them contains no sample yet.
///
/// The paper throws darts evenly in (u, v) until 1000 successive ones fail. Here they are thrown into the gaps between
/// the balls, in cells of the face about as large as the balls, until no gap is left: the density of darts follows the
/// surface in space instead of its parameters, no gap remains, and the time is linear in the number of samples. The
/// same seed gives the same samples.
std::vector<FaceSampler::Candidate> sample_sprinkle(const SamplingContext& context, int face,
                                                    const FaceBoundary& border, std::uint64_t seed);

}  // namespace mq::triangulate

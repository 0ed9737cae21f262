// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "triangulate/face_sampler.h"

namespace mq::triangulate {

/// The Sprinkle algorithm (Ruiz et al., section 2.3): random points of the face, kept where the ball of radius r(K)
/// around them holds no sample yet.
///
/// The paper throws darts evenly in (u, v) until 1000 fail one after the other. Here they are thrown into cells of
/// the face that no ball covers yet, which are quartered until none is left (Ebeida, Mitchell, Patney, Davidson, Owens
/// 2012): the density of darts follows the surface in space instead of its parameters, no gap is left over, and the
/// time is linear in the samples. `coarse` is any triangulation of the face. The same seed gives the same samples.
std::vector<FaceSampler::Candidate> sample_sprinkle(const SamplingContext& context, int face,
                                                    const geometry::FaceBorder& border,
                                                    const geometry::FaceTriangulation& coarse, std::uint64_t seed);

}  // namespace mq::triangulate

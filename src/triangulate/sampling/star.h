// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/sampling/face_sampler.h"

namespace mq::triangulate {

/// The Star algorithm (Ruiz et al., section 2.4): around every sample, starting with those of the border, a regular
/// hexagon of radius r(K) in the tangent plane; its corners are projected onto the surface and become samples where
/// there is room.
///
/// Every step is computed in space. The parameters (u, v) serve the geometry engine only as initial guesses, so that
/// another parameterisation of the same surface gives the same samples within the engine's accuracy.
std::vector<FaceSampler::Candidate> sample_star(const SamplingContext& context, int face, const FaceBoundary& border);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/sampling/face_sampler.h"

namespace mq::triangulate {

/// The pseudo-Delaunay triangulation of Ruiz et al., section 2.5: starting with the border as a queue of front edges,
/// every edge gets the vertex whose triangle's circumscribing ball contains no other vertex, and the new edges are
/// queued. All computations are in space: from (u, v) only the direction of the border is used.
///
/// The paper gives no rule for the cases that its test leaves open; here, vertices on the other side of a thin wall or
/// on another turn of a thread are ignored; among vertices on one ball (cocircular ones) the first that fits is used;
/// no triangle may overlap another one at any of its corners, or cross the front; edges without an empty ball, near a
/// border with other vertices close behind it, get the vertex with the smallest ball.
///
/// The result is verified: every piece of the border is used once, every other edge twice, all sites are used, the
/// Euler characteristic is that of `coarse`, and no triangle's normal deviates from its surface by more than 75
/// degrees (90 where nothing else fits). Otherwise `failure` gives the reason.
FaceMesh triangulate_pseudo_delaunay(const SamplingContext& context, int face, const FaceBoundary& border,
                                     const std::vector<FaceSampler::Candidate>& samples, const FaceMesh& coarse);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/face_sampler.h"

namespace mq::triangulate {

/// The pseudo-Delaunay triangulation of Ruiz et al., section 2.5: from a queue of front edges, at first the border,
/// every edge gets the vertex whose triangle's circumscribing ball holds no other vertex, and the new edges are queued.
/// All in space: of (u, v) only the direction of the border is used.
///
/// The paper gives no rule for what its test leaves open, which is decided here: vertices on the other side of a thin
/// wall or on another turn of a thread are not seen; of vertices on one ball (cocircular ones) the first that fits is
/// taken; no triangle may overlap one that is there at any of its corners, or cross the front; edges without an empty
/// ball, near a border that other vertices lie close behind, get the vertex with the smallest one.
///
/// The whole is verified: every piece of the border used once, every other edge twice, all sites used, the Euler
/// characteristic of `coarse`, no triangle turned away from its surface (by 75 degrees, by 90 where nothing else fits).
/// Otherwise `failure` says what is wrong.
geometry::FaceTriangulation triangulate_pseudo_delaunay(const SamplingContext& context, int face,
                                                        const geometry::FaceBorder& border,
                                                        const std::vector<FaceSampler::Candidate>& samples,
                                                        const geometry::FaceTriangulation& coarse);

}  // namespace mq::triangulate

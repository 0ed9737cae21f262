// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "geometry/face_triangulation.h"
#include "geometry/topology.h"

namespace mq::triangulate {

/// What is wrong with a triangulation of a face whose links are complete, by the same face's `coarse` one: sites left
/// out, pieces of the border missing, another Euler characteristic, triangles without area. Empty: nothing.
std::string fault_of_face(const geometry::FaceTriangulation& face, const geometry::FaceTriangulation& coarse,
                          const geometry::Topology& topology);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "geometry/topology.h"
#include "triangulate/initial/face_triangulator.h"

namespace mq::triangulate {

/// Names the defect of a triangulation of a face whose links are complete, compared with the `coarse` triangulation of
/// the same face: omitted sites, omitted pieces of the border, another Euler characteristic, or triangles without
/// area. Returns an empty string if there is none.
std::string fault_of_face(const FaceMesh& face, const FaceMesh& coarse, const geometry::Topology& topology);

}  // namespace mq::triangulate

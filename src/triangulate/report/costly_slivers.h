// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/message.h"
#include "mesh/triangle_mesh.h"

namespace mq::triangulate {

/// A sentence that names the sliver faces for which a mesh has most of its small triangles, and the remedy; empty if
/// there are none, or if they cost less than 10,000 triangles.
/// @param size  largest side of the shape's box, mm
Message costly_slivers(const mesh::TriangleMesh& mesh, double size);

}  // namespace mq::triangulate

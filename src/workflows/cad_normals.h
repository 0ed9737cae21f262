// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "geometry/engine.h"
#include "mesh/triangle_mesh.h"

class TopoDS_Shape;

namespace mq::workflows {

/// For each triangle the normal of its CAD face at the point nearest to its middle, outward; that of the triangle
/// itself where it has no face, or the surface has no normal there.
/// @param mesh   of the shape: `triangle_face` names its faces
/// @param exact  grows by the number of triangles whose normal is that of a face
/// @throws Cancelled
std::vector<Vec3> cad_normals(geometry::Engine& engine, const mesh::TriangleMesh& mesh, const TopoDS_Shape& shape,
                              Progress& progress, std::size_t& exact);

/// For each corner of the triangles of a mesh of a shape the normal at the point of its CAD face that is nearest to it,
/// outward; zero where it has no face, or the surface has no normal there. Empty for a mesh without faces.
/// @throws Cancelled
std::vector<Vec3> corner_normals(geometry::Engine& engine, const mesh::TriangleMesh& mesh, const TopoDS_Shape& shape,
                                 Progress& progress);

}  // namespace mq::workflows

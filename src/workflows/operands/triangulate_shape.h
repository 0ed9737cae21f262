// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "geometry/engine.h"
#include "triangulate/work_mesh/options.h"
#include "triangulate/work_mesh/result.h"

class TopoDS_Shape;

namespace mq::triangulate {
class MeshCache;
}

namespace mq::workflows {

/// Reads a shape on the engine's thread and meshes it. A note tells where single precision changes the volume of a thin
/// model by more than a hundredth.
/// @param cache  null: nothing is taken over from earlier calls
/// @throws InvalidInput, TopologyError, GeometryError naming the entity; Cancelled.
triangulate::Result triangulate_shape(geometry::Engine& engine, const TopoDS_Shape& shape,
                                      const triangulate::TriangulateOptions& options, Progress& progress,
                                      triangulate::MeshCache* cache = nullptr);

/// The report of a surface with its self-intersections, which are searched unless they are known.
/// @throws Cancelled
mesh::MeshReport report_with_crossings(const triangulate::Result& surface, Progress& progress);

/// report_with_crossings() with the largest distance of the triangles from the shape's face nearest to each.
mesh::MeshReport measure_against_shape(const triangulate::Result& surface, const TopoDS_Shape& shape,
                                       Progress& progress);

/// For each triangle the largest distance of its corners, edge middles and centroid from the faces of the shape, mm.
std::vector<double> triangle_deviations(const mesh::TriangleMesh& mesh, const TopoDS_Shape& shape, Progress& progress);

}  // namespace mq::workflows

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "curve/curve.h"
#include "geometry/engine.h"
#include "given/matching/given_mesh.h"
#include "given/mixed/curve_mixed.h"
#include "given/simplices/cad_distance.h"
#include "given/simplices/measure_given.h"
#include "triangulate/work_mesh/options.h"
#include "triangulate/work_mesh/result.h"

class TopoDS_Shape;

namespace mq::workflows {

/// Meshes a shape and curves the mesh. Where it cannot be filled, or elements stay invalid, a finer straight mesh is
/// curved instead, three times at most; the result is the first one with the fewest invalid elements.
/// @throws InvalidInput, TopologyError, GeometryError naming the entity; tetrahedralise::MeshingFailed where no attempt
/// could be
///     filled; Cancelled.
curve::CurvedMesh curve_shape(geometry::Engine& engine, const TopoDS_Shape& shape, const curve::CurveOptions& options,
                              const triangulate::TriangulateOptions& straight, Progress& progress);

/// Curves a mesh that triangulate_shape() made of the shape, once.
/// @throws as curve::curve.
curve::CurvedMesh curve_surface(geometry::Engine& engine, const TopoDS_Shape& shape, const triangulate::Result& surface,
                                const curve::CurveOptions& options, Progress& progress);

/// Curves a mesh of the shape that another program made, see given::curve_given.
/// @param imprint  whether coincident faces of two solids are one face, as in meshes that join the solids; tried, too,
///     if the mesh does not match separate solids
/// @throws as given::curve_given.
curve::CurvedMesh curve_given_mesh(geometry::Engine& engine, const TopoDS_Shape& shape, const given::GivenMesh& given,
                                   const curve::CurveOptions& options, bool imprint, Progress& progress);

/// Curves a mesh with prisms, pyramids, hexahedra or quadrilaterals likewise, see given::curve_mixed.
given::CurvedMixedMesh curve_mixed_mesh(geometry::Engine& engine, const TopoDS_Shape& shape,
                                        const given::MixedMesh& given, const curve::CurveOptions& options, bool imprint,
                                        Progress& progress);

/// Measures the triangles of a given surface against the shape, see given::measure_given_surface.
given::GivenSurfaceMeasures measure_given_surface(geometry::Engine& engine, const TopoDS_Shape& shape,
                                                  const std::vector<Vec3>& nodes, int order,
                                                  const std::vector<std::int32_t>& triangles, Progress& progress);

/// Distances of sampled points of the CAD faces from the surface of a mesh.
/// @throws as given::cad_distances.
given::CadDistances cad_distances(geometry::Engine& engine, const TopoDS_Shape& shape, const std::vector<Vec3>& nodes,
                                  int order, const std::vector<std::int32_t>& triangles, Progress& progress);

/// The distance of each point from the faces of a shape, mm, independent of its mesh (geometry::distances_to_faces).
std::vector<double> distances_to_faces(geometry::Engine& engine, const TopoDS_Shape& shape,
                                       const std::vector<Vec3>& points, Progress& progress);

}  // namespace mq::workflows

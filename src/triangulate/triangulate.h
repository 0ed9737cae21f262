// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "base/progress.h"
#include "geometry/engine.h"
#include "triangulate/work_mesh/options.h"
#include "triangulate/work_mesh/result.h"

/// Quality triangulation of CAD models behind one function: Aftosmis 1999, Algorithms M and E, and the
/// curvature-sensitive sampling of Ruiz et al.
namespace mq::triangulate {

class MeshCache;

/// Meshes all volumes of a shape.
///
/// Guarantees: every angle is at least `min_angle` except in the triangles listed in the report (not without
/// `polish`); every vertex is a single-precision point; terminates for every input.
///
/// With `memory`: an identical input returns the cached result. Otherwise faces with unchanged geometry and options
/// start from their cached triangles; the guarantees are the same, but the mesh depends on the cache. If the result is
/// worse than the cached one (more exempt triangles, larger distance, new intersections), the shape is meshed from
/// scratch. Nothing is cached for the sampling methods or `keep_edges = Feature`.
/// @throws InvalidInput, TopologyError, GeometryError naming the entity; Cancelled.
Result triangulate(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                   const TriangulateOptions& options = {}, Progress* progress = nullptr, MeshCache* memory = nullptr);

}  // namespace mq::triangulate

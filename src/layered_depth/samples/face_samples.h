// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "base/progress.h"
#include "geometry/engine.h"
#include "layered_depth/samples/layered_depth_image.h"
#include "layered_depth/samples/node_consistency.h"

namespace mq::layered_depth {

/// The CAD shape from which an operand was meshed.
struct CadShape {
    std::shared_ptr<geometry::Model> model;            ///< null: the operand is a mesh only
    const std::vector<std::int32_t>* faces = nullptr;  ///< for each triangle of the mesh the face of the model
    double chord_height = 0.0;                         ///< mm: largest distance of the mesh from the faces
};

/// The counts of sampling the faces of shapes.
struct FaceSampleCounts {
    std::size_t on_faces = 0;  ///< lower bound of the samples with depth and normal of a CAD face
    /// Samples of shapes that keep depth and normal of their triangle, as no point of its face is near; includes
    /// removed ones.
    std::size_t on_mesh = 0;
    std::size_t passed =
        0;  ///< samples that were removed, as the face is crossed in the other direction than the triangle
    ConsistencyCounts nodes;
};

/// Moves the samples of an operand from its triangles onto the CAD faces behind them.
///
/// The triangles determine which faces a ray meets and in which order (rasterise: consistent at edges, seams, vertices
/// and poles without a tolerance). The new point is the intersection of the ray and the face's whole surface at which
/// the ray enters or leaves the solid as at the triangle; if there are several, the one nearest to the triangle.
/// Planes, cylinders, cones, spheres and tori are solved in closed form, other surfaces by Newton's method from the
/// parameters of the triangle's corners, all in parallel. A point farther from the triangle's plane than the mesh may
/// deviate is refused, and the sample stays on the triangle. Then the rays are made consistent once more
/// (restore_order, make_consistent).
/// @param origin of the frame of the operands in that of the model, mm
/// @throws Cancelled
void sample_faces(LayeredDepthSet& set, const OperandSet& pair, const SampleGrid& grid, const Vec3& origin,
                  const CadShape& shape, geometry::Engine& engine, FaceSampleCounts& counts, const Progress* progress);

}  // namespace mq::layered_depth

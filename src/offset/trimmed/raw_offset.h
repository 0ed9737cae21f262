// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/proof/distance_bounds.h"
#include "mesh/triangle_mesh.h"

namespace mq::offset {

/// A surface without border, given by half-edges. The two sides of a sheet may share their vertices: only `twins` tells
/// which triangles are neighbours.
struct ClosedSurface {
    std::vector<Vec3> points;
    std::vector<mesh::Triangle> triangles;
    std::vector<std::int32_t> twins;   ///< see mesh::edge_twins: every corner has a twin
    std::vector<std::int32_t> source;  ///< by triangle: the triangle of the input
    /// By corner: the unit normal of the CAD face there; zero if it is not known. Empty if none is known.
    std::vector<Vec3> normals{};
};

struct RawOffsetOptions {
    double distance = 0.0;   ///< mm, above 0: towards the side to which the triangles' normals point
    double tolerance = 0.0;  ///< mm: largest distance of the raw offset from points at `distance` ...
    /// mm: ... or this, if it is larger and vertices are moved along the normals of CAD faces
    double face_tolerance = 0.0;
    double deep = 0.0;  ///< mm: points nearer to the surface than this lie within the offset
    const mesh::SearchedSurface* searched = nullptr;  ///< the surface
    /// mm: how far the offset of a sheet is extended beyond its border, so that the surface that cuts the sheet there
    /// meets no vertices.
    double extension = 0.0;
    const Progress* progress = nullptr;  ///< may be null
};

/// All points p + d u for points p of a surface and directions u between the normals at p: the surface on which the
/// centre of a ball with radius d may lie while the ball touches the surface from its front. It contains the boundary
/// of all points within the distance d, and crosses itself where that boundary has sharp edges and where pieces of the
/// surface are near to each other (the raw offset of Farouki 1985; the convolution of Guibas, Ramshaw and Stolfi 1983).
///
/// Each triangle of the surface gives one triangle, moved along the directions at its corners. Triangles around a
/// vertex share one direction as far as their normals allow within the tolerance, so that a smooth surface keeps its
/// connectivity. The direction is the normal of the CAD face, if that is known. The mean of the triangles' normals
/// differs from it by up to half of the angle between neighbours; offset to the centre of curvature such a surface
/// crosses itself everywhere. Different directions are joined by an arc. Strips of triangles between two arcs round the
/// edges, caps on spheres round the vertices.
struct RawOffset {
    std::vector<Vec3> vertices;  ///< single-precision numbers
    std::vector<mesh::Triangle> triangles;
    std::vector<std::int32_t> source;  ///< by triangle: ClosedSurface::source of the triangle that it is offset from
};

/// @throws Cancelled
RawOffset raw_offset(const ClosedSurface& surface, const RawOffsetOptions& options);

}  // namespace mq::offset

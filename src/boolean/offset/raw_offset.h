// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "boolean/offset/offset_error.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// A surface without border, by its half-edges. Sides of a sheet may share their vertices: only `twins` tells which
/// triangles are neighbours.
struct ClosedSurface {
    std::vector<Vec3> points;
    std::vector<mesh::Triangle> triangles;
    std::vector<std::int32_t> twins;   ///< see mesh::edge_twins: all corners have one
    std::vector<std::int32_t> source;  ///< the triangle of the input that each one is
    std::vector<Vec3> normals;  ///< for each corner that of the CAD face there; zero where not known; empty: nowhere
};

struct RawOffsetOptions {
    double distance = 0.0;        ///< mm, above 0: to the side to which the triangles' normals point
    double tolerance = 0.0;       ///< mm: the raw offset is no farther than this from points at the distance ...
    double face_tolerance = 0.0;  ///< mm: ... than the larger of both where it is moved along normals of CAD faces
    double deep = 0.0;            ///< mm: what is nearer to the surface than this is within the offset
    const SearchedSurface* searched = nullptr;  ///< the surface
    /// mm: how far the offset of a sheet goes on beyond its border, so that what cuts the sheet there meets no
    /// vertices.
    double extension = 0.0;
    const Progress* progress = nullptr;  ///< may be null
};

/// The surface that a ball's centre may lie on while the ball touches a surface from its front: all points p + d u, for
/// points p of the surface and directions u between the normals there. It holds the boundary of all that is within the
/// distance d, and crosses itself where that boundary has sharp edges and where parts of the surface are near to each
/// other (the raw offset of Farouki 1985; the convolution of Guibas, Ramshaw and Stolfi 1983).
///
/// Each triangle gives one, moved along the directions at its corners. Triangles around a vertex have one direction as
/// far as their normals allow by the tolerance, so that a smooth surface keeps its connectivity. It is the mean of the
/// normals of CAD faces, where they are known, else of triangles: these scatter by half of the angle between
/// neighbours, so that an offset to near the centre of curvature crosses itself many times. Where directions
/// differ, an arc joins them; strips of triangles between two arcs round the edges off, caps on spheres the vertices.
struct RawOffset {
    std::vector<Vec3> vertices;  ///< single-precision numbers
    std::vector<mesh::Triangle> triangles;
    std::vector<std::int32_t> source;  ///< ClosedSurface::source of a triangle from which each one is offset
};

/// @throws Cancelled
RawOffset raw_offset(const ClosedSurface& surface, const RawOffsetOptions& options);

}  // namespace mq::boolean

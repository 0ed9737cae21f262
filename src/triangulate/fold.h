// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "mesh/surface_mesh.h"

namespace mq::triangulate {

/// A corner of a triangle that may not exist yet.
struct Corner {
    Vec3 point;
    Vec3 normal;  ///< of the CAD face; zero where it has none
};

Corner corner_of(const mesh::SurfaceMesh& mesh, int site);

/// How well a triangle follows its surface: the smallest cosine between its normal and those at its corners.
/// -1 for a triangle without area.
double alignment(const Corner& a, const Corner& b, const Corner& c);
double alignment(const mesh::SurfaceMesh& mesh, int triangle);

/// A new triangle must lie within 60 degrees of its surface, unless those that it replaces were worse.
constexpr double kAligned = 0.5;
/// Swaps may go as far as 73 degrees: they undo each other, and refinement turns the triangles back.
constexpr double kAlignedSwap = 0.3;
/// For triangles that would have to be exempted otherwise.
constexpr double kAlignedAtLast = 0.1;
/// Triangles turned farther than 40 degrees are refined for that alone: with them around, swaps and insertions are
/// refused that good angles need.
constexpr double kWellAligned = 0.766;
constexpr double kAlignedAtApex = 0.1;

/// The side of a triangle over whose ends the CAD normal turns most, as a half-edge.
int most_turned_side(const mesh::SurfaceMesh& mesh, int triangle);

}  // namespace mq::triangulate

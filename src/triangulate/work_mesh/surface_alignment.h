// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "base/tuning.h"
#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// A corner of a triangle that need not exist yet.
struct Corner {
    Vec3 point;
    Vec3 normal;  ///< normal of the CAD face; zero if it has none
};

Corner corner_of(const ClassifiedMesh& mesh, int site);

/// Returns the alignment of a triangle with its surface: the smallest cosine between its normal and those at its
/// corners. -1 for a triangle without area.
double alignment(const Corner& a, const Corner& b, const Corner& c);
double alignment(const ClassifiedMesh& mesh, int triangle);

/// Cosine of 60 degrees: the normal of a new triangle must not deviate more, unless those of the replaced triangles
/// did.
MESHQUALITY_TUNED(double, kAligned, 0.5);
/// Cosine of 73 degrees: the limit for swaps, which can be undone, and whose triangles refinement aligns again.
MESHQUALITY_TUNED(double, kAlignedSwap, 0.3);
/// Least cosine for triangles that would otherwise be exempt.
MESHQUALITY_TUNED(double, kAlignedAtLast, 0.1);
/// Cosine of 40 degrees: triangles whose normals deviate more are refined for this reason alone, since around them
/// swaps and insertions are refused that good angles need.
MESHQUALITY_TUNED(double, kWellAligned, 0.766);
MESHQUALITY_TUNED(double, kAlignedAtApex, 0.1);  // Least cosine at the apex of a slender cone.

/// Returns the side of a triangle along which the CAD normal turns most, as a half-edge.
int most_turned_side(const ClassifiedMesh& mesh, int triangle);

}  // namespace mq::triangulate

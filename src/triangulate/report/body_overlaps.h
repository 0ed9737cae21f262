// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "mesh/quality/mesh_report.h"
#include "triangulate/measure/body_contacts.h"
#include "triangulate/report/manifold_output.h"

namespace mq::triangulate {

/// The pairs of bodies that are not apart: those whose triangles cross, unless they only touch, and solids in solids.
///
/// To test whether a solid lies in another one, the winding number (see mesh::WindingNumber) of the other's triangles
/// is evaluated at one triangle of each connected set of the first's triangles that cross none of the other: such a set
/// is on one side. Only solids with nested boxes are tested. A solid in a void of another one is in none.
/// @param contacts  of all triangles that cross
/// @param deviation  largest distance of the mesh from its faces, mm
/// @throws Cancelled
std::vector<mesh::BodyOverlap> body_overlaps(const Workspace& work, const std::vector<FaceContact>& contacts,
                                             const Output& out, double deviation);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/arrangement/soup.h"
#include "boolean/near_coincidence/facing_search.h"

namespace mq::boolean {

/// Two triangles of different operands that lie on each other within the tolerance.
struct ContactFace {
    std::int32_t earlier = -1;  ///< the triangle of the operand that comes first
    std::int32_t later = -1;
    /// Heights of the later triangle over the plane of the earlier one where they overlap, mm.
    double low = 0.0;
    double high = 0.0;
    double most = 0.0;       ///< mm, the largest gap that counts as contact in their region
    bool same_side = false;  ///< the normals have the same direction
};

/// The pairs of triangles in which faces of different operands lie on each other within the tolerance, mm; in order of
/// the operands, then of the triangles. Faces in one plane, and twins, have heights of 0.
///
/// Surfaces that cross at a small angle, or touch in a point, are within the tolerance of each other, too: in a strip
/// or a disc. The area within a distance tells them from a common face: that of a strip or a disc is proportional to
/// the distance, that of a common face is constant. So pairs of triangles that face each other within twice the
/// tolerance are joined to regions, and a region is a common face if nine tenths of its area are within the tolerance,
/// and if it is at least eight times as wide as its gap. A pair of the region counts if its gap is at most four times
/// the gap within which nine tenths of the area are; so the pairs of a fillet beside a plane face are left out.
///
/// Where a wall is thinner than the tolerance both of its sides are near the other surface: the nearer one counts.
/// @param search  with a reach of at least twice the tolerance
/// @param least   mm, a gap that cannot be told from 0 in single precision
/// @throws Cancelled
std::vector<ContactFace> contact_faces(const Soup& soup, const FacingSearch& search,
                                       const std::vector<CoincidentTriangle>& twins, double tolerance, double least,
                                       const Progress& progress);

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "base/progress.h"
#include "contour/contour.h"

namespace mq::contour {

/// Whether a triangle with these corners, which comes from this triangle of the input, is accepted. The first corner is
/// the one that moved.
using TriangleFilter = std::function<bool(const std::array<Vec3, 3>&, std::int32_t source)>;

/// The conditions on collapses of edges.
struct CollapseLimits {
    double distance = 0.0;  ///< mm, of vertices from the planes that their triangles represent
    double border = std::numeric_limits<double>::infinity();   ///< mm: of vertices from borders between patches
    double longest = std::numeric_limits<double>::infinity();  ///< mm: of the edges of triangles that are moved
    /// By triangle: whether the triangle and its vertices must stay as they are; empty: none must.
    std::vector<char> fixed;
    /// Asked for each moved triangle whether its new place is accepted; empty: all are. Called by several threads.
    TriangleFilter accepts;
    /// Points that each stay within a distance (mm) of a triangle of their patch: Contour::kept says of which.
    const std::vector<Vec3>* kept_points = nullptr;
    double kept_distance = 0.0;
    /// Collapses at these places are tested for triangles that meet after them. If they are not all places, the caller
    /// searches the result: on a surface that is not folded nearly no collapse makes triangles meet.
    std::vector<Box> tested;
    /// Box that contains all triangles that are not fixed, before and after collapses.
    Box within{Vec3::Constant(-1e300), Vec3::Constant(1e300)};
};

/// Collapses edges of a surface in the order of their costs (Garland and Heckbert 1997). The points are
/// single-precision numbers, before and after. If the vertices of fixed triangles come first in the list, they keep
/// their order.
///
/// A collapse is made only if the surface stays 2-manifold (link condition), no triangle turns away from its plane and,
/// no moved triangle meets another one where that is tested (exactly).
/// @param from  fraction of the stage that was done before; this call advances it to the end
/// @throws Cancelled
void collapse_edges(Contour& surface, const std::vector<Crossing>& crossings, const CollapseLimits& limits,
                    Progress& progress, double from = 0.0);

}  // namespace mq::contour

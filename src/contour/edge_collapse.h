// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "base/progress.h"
#include "contour/contour.h"

namespace mq::contour {

/// Whether a triangle may be where its corners are.
using TriangleFilter = std::function<bool(const std::array<Vec3, 3>&)>;

/// What a collapse of edges must keep.
struct CollapseLimits {
    double distance = 0.0;  ///< from vertices to the planes that their triangles stand for, mm
    double border = std::numeric_limits<double>::infinity();   ///< from vertices to borders between patches, mm
    double longest = std::numeric_limits<double>::infinity();  ///< length of edges of triangles that are moved, mm
    /// Triangles that stay as they are, with their vertices; empty: there are none.
    std::vector<char> fixed;
    /// Asked of triangles that are moved; empty: all may. Called by several threads.
    TriangleFilter accepts;
    /// Whether each collapse is tested for triangles that meet then. Otherwise the caller looks for those in the end:
    /// of a surface that is not folded nearly no collapse makes any.
    bool keeps_apart = true;
    /// Where all others are, before and after.
    Box within{Vec3::Constant(-1e300), Vec3::Constant(1e300)};
};

/// Collapses edges of a surface, those first that cost least (Garland and Heckbert 1997). Its points are
/// single-precision numbers, and stay that. Of the vertices of fixed triangles those that come first keep their order.
///
/// A collapse is made only where the surface stays 2-manifold (link condition), no triangle turns away from its plane,
/// and, where the limits say so, no triangle that is moved meets another one (exact).
/// @param from  fraction of the stage that was done before; this is the rest
/// @throws Cancelled
void collapse_edges(Contour& surface, const std::vector<Crossing>& crossings, const CollapseLimits& limits,
                    Progress& progress, double from = 0.0);

}  // namespace mq::contour

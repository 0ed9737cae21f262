// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "curve/surface/editor.h"

/// Coarse straight triangles of a thin or strongly curved wall may pierce those of its other side, though the CAD faces
/// do not: such a surface cannot be filled.
namespace mq::curve {

/// Two triangles of one solid's boundary that touch or cross elsewhere than in shared vertices or edges.
using Crossing = std::pair<int, int>;

/// The crossings of the straight triangles around a volume, at most a few hundred.
std::vector<Crossing> find_self_intersections(const CurvedSurface& surface, std::size_t volume,
                                              const Progress& progress);

/// Halves the longest edges of triangles that cross, again and again, until none do or nothing helps.
/// @return the number of edges halved.
int refine_crossings(SurfaceEditor& editor, const geometry::Topology& topology, const Progress& progress);

/// The place where the surface around a volume is hardest to fill: the faces that cross, or the flattest triangle. For
/// messages.
std::string first_fault(const CurvedSurface& surface, const geometry::Topology& topology, std::size_t volume,
                        const Progress& progress);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "curve/elements/element_kind.h"

namespace mq::curve {

/// Solid elements of one order by their nodes in Gmsh's order.
struct ElementNodes {
    ElementKind kind = ElementKind::Tetrahedron;
    std::vector<std::int32_t> nodes;
};

/// Moves free nodes of elements around some bad ones until J at all samples of these is positive by a margin, or grows
/// no more.
///
/// The objective is that of untangle.h, on samples of J relative to those of the straight elements; it is minimised by
/// conjugate gradients (Polak and Ribiere 1969) behind a barrier that moves up with the least sample.
/// @param bad     indices of elements
/// @param layers  of elements around them, joined by nodes, that may change, too
/// @param fixed   by node: corners, and nodes on the CAD
/// @return how many patches of elements were worked on
std::size_t relax_nodes(const std::vector<ElementNodes>& elements, int order, const std::vector<Vec3>& straight,
                        const std::vector<char>& fixed, const std::vector<std::size_t>& bad, int layers,
                        std::vector<Vec3>& nodes, const Progress& progress);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "elements/product/element_kind.h"

namespace mq::given {

/// Solid elements of one order by their nodes in Gmsh's order.
struct ElementNodes {
    elements::ElementKind kind = elements::ElementKind::Tetrahedron;
    std::vector<std::int32_t> nodes;
};

/// Moves free nodes of elements around some bad ones until J at all samples of these elements is positive by a margin,
/// or does not grow any more.
///
/// The objective is that of untangle.h, on samples of J relative to the straight elements. It is minimised by conjugate
/// gradients (Polak and Ribiere 1969) with a barrier that rises with the least sample.
/// @param bad     indices of the bad elements
/// @param layers  number of layers of elements around them, connected by nodes, that may change as well
/// @param fixed   by node whether it must stay: corners, and nodes on the CAD
/// @return number of patches of elements that were optimised
std::size_t relax_nodes(const std::vector<ElementNodes>& elements, int order, const std::vector<Vec3>& straight,
                        const std::vector<char>& fixed, const std::vector<std::size_t>& bad, int layers,
                        std::vector<Vec3>& nodes, const Progress& progress);

}  // namespace mq::given

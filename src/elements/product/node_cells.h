// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "elements/product/element_kind.h"

namespace mq::elements {

/// The tetrahedra that the nodes of a solid element divide it into, by nodes in Gmsh's order, seen from either side.
///
/// All kinds are pieces of the space of whole numbers that planes x = y, y = z and z = x and those through whole
/// numbers bound, so that the simplices between a corner of a cube and the opposite one (Freudenthal 1942, Kuhn 1960)
/// divide them: hexahedra have all points, prisms those with x >= y, tetrahedra those with x >= y >= z, and pyramids,
/// whose levels are counted from the apex, those with x >= y and x >= z.
/// @throws InvalidInput for surface elements and orders out of 1 to kMaxOrder
const std::vector<std::array<int, 4>>& node_cells(ElementKind kind, int order);

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/vec.h"
#include "elements/product/element_kind.h"

namespace mq::given {

/// The nodes inside of an element as weighted sums of those on its boundary: on the edges of a triangle or
/// quadrilateral, on the faces of a solid.
///
/// Quadrilaterals, prisms and hexahedra are blended transfinitely (Gordon and Hall 1973), level by level. Between
/// bottom and top the blend is linear; the deviation of the sides from that is blended within each level. So an element
/// that is linear from bottom to top stays linear, which layers rely on. Pyramids are blended within each level,
/// simplices as in bezier/blending.h.
struct Blending {
    std::vector<int> inner;  ///< nodes in Gmsh's order
    Eigen::MatrixXd from;    ///< weights: (inner nodes, all nodes), zero for inner nodes

    static const Blending& of(elements::ElementKind kind, int order);
    /// Sets the inner nodes from the others.
    void apply(std::vector<Vec3>& nodes) const;
};

}  // namespace mq::given

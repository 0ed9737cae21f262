// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/vec.h"
#include "curve/elements/element_kind.h"

namespace mq::curve {

/// The nodes inside of an element as sums of those on its boundary: of a triangle or quadrilateral on its edges, of a
/// solid on its faces.
///
/// Quadrilaterals, prisms and hexahedra are blended transfinitely (Gordon and Hall 1973), level by level: linear
/// between bottom and top, and what the sides deviate from that is blended within each level. So an element that is
/// linear from bottom to top stays so, which layers rely on. Pyramids are blended within each level, simplices as in
/// bezier/blending.h.
struct Blending {
    std::vector<int> inner;  ///< nodes in Gmsh's order
    Eigen::MatrixXd from;    ///< (inner nodes, all nodes): zero for inner ones

    static const Blending& of(ElementKind kind, int order);
    /// Sets the inner nodes.
    void apply(std::vector<Vec3>& nodes) const;
};

}  // namespace mq::curve

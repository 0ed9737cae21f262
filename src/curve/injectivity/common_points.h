// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "curve/injectivity/surface_patches.h"
#include "elements/product/element_kind.h"

namespace mq::curve {

/// Solid elements of one kind and order, with their nodes in Gmsh's order, one element after the other.
struct SolidBlock {
    /// A face of an element: which of the element's nodes it has, in Gmsh's order.
    struct Face {
        elements::ElementKind kind = elements::ElementKind::Triangle;
        int order = 1;
        std::vector<std::int32_t> nodes;
    };
    elements::ElementKind kind = elements::ElementKind::Tetrahedron;
    int order = 1;
    int nodes_per_element = 4;
    std::vector<std::int32_t> nodes;
    std::vector<Face> faces;
};

/// A point inside of two elements.
struct CommonPoint {
    std::array<std::int32_t, 2> elements;  ///< numbered from block to block
    Vec3 point;                            ///< mm
};

/// Bodies of a mesh that overlap: for each pair of bodies at most one point, which is proven to be inside of an element
/// of each.
///
/// Elements whose boxes meet are divided into tetrahedra between their nodes. If two of these have more than a point,
/// an edge or a face in common, the middle of their intersection is tried. The proof is the winding number of the faces
/// of each element around that point. Overlaps less deep than `kTouching` of the mesh's size do not count.
/// @param body  by element, numbered from block to block
/// @throws InvalidInput if the sizes of the lists do not agree; Cancelled
std::vector<CommonPoint> common_points(const std::vector<Vec3>& nodes, const std::vector<SolidBlock>& blocks,
                                       const std::vector<std::int32_t>& body, Progress* progress = nullptr);

}  // namespace mq::curve

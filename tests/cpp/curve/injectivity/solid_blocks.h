// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/injectivity/common_points.h"
#include "elements/product/reference_nodes.h"

namespace mq::curve {

/// Elements that each have nodes of their own, of order 1.
struct LooseSolids {
    std::vector<Vec3> nodes;
    std::vector<SolidBlock> blocks;

    /// The reference element of a kind, between 0 and 1 (pyramids: -1 and 1), times `size` and moved.
    void add(elements::ElementKind kind, const Vec3& shift, double size = 1.0) {
        SolidBlock block;
        block.kind = kind;
        block.nodes_per_element = elements::full_node_count(kind, 1);
        for (const elements::GridPoint& p : elements::gmsh_nodes(kind, 1)) {
            block.nodes.push_back(static_cast<std::int32_t>(nodes.size()));
            nodes.push_back(size * Vec3(p[0], p[1], p[2]) + shift);
        }
        for (const std::vector<std::size_t>& corners : elements::sides_of(kind).faces) {
            const elements::ElementKind face =
                corners.size() == 3 ? elements::ElementKind::Triangle : elements::ElementKind::Quadrilateral;
            block.faces.push_back({face, 1, {corners.begin(), corners.end()}});
        }
        blocks.push_back(block);
    }
    /// All elements are bodies of their own.
    std::vector<std::int32_t> bodies() const {
        std::vector<std::int32_t> all;
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            all.push_back(static_cast<std::int32_t>(i));
        }
        return all;
    }
    /// The faces of all elements, outward.
    std::vector<SideBlock> sides() const {
        std::vector<SideBlock> all;
        for (const SolidBlock& block : blocks) {
            for (const SolidBlock::Face& face : block.faces) {
                SideBlock side{face.kind, face.order, static_cast<int>(face.nodes.size()), {}};
                for (const std::int32_t i : face.nodes) {
                    side.nodes.push_back(block.nodes[static_cast<std::size_t>(i)]);
                }
                all.push_back(side);
            }
        }
        return all;
    }
};

constexpr elements::ElementKind kSolidKinds[] = {elements::ElementKind::Tetrahedron, elements::ElementKind::Pyramid,
                                                 elements::ElementKind::Prism, elements::ElementKind::Hexahedron};

}  // namespace mq::curve

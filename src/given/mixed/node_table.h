// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/key_set.h"
#include "base/vec.h"
#include "given/mixed/mixed_mesh.h"

namespace mq::given {

/// Weights of the corners of an element at its nodes in Gmsh's order: (nodes, corners). Applied to the corners they
/// give the nodes of the straight element.
const Eigen::MatrixXd& corner_weights(elements::ElementKind kind, int order);

/// Numbers the nodes of elements of one order. Each node has one number, also if several elements have it. Corners come
/// first: corner v is node v.
class NodeTable {
  public:
    /// @param corners  positions of the corners, mm
    NodeTable(int order, std::vector<Vec3> corners);

    int order() const { return order_; }
    /// All nodes of an element, or of a face of it, in Gmsh's order. Every call creates new nodes inside of a solid.
    std::vector<std::int32_t> nodes_of(elements::ElementKind kind, const std::int32_t* corners);
    /// The nodes of an edge from a to b, both included.
    std::vector<std::int32_t> edge(std::int32_t a, std::int32_t b);

    /// Positions of the nodes of the straight elements.
    const std::vector<Vec3>& straight() const { return straight_; }
    std::size_t vertices() const { return vertices_; }

  private:
    /// A node by the corners around it and their weights, scaled to whole numbers: up to four pairs.
    using Key = std::array<std::int32_t, 8>;

    std::int32_t node(const std::vector<std::array<std::int32_t, 2>>& weights, bool shared);

    int order_;
    std::size_t vertices_;
    std::vector<Vec3> straight_;
    std::unordered_map<Key, std::int32_t, KeyHash> known_;
};

}  // namespace mq::given

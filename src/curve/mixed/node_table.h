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
#include "curve/mixed/mixed_mesh.h"

namespace mq::curve {

/// Weights of the corners of an element at its nodes in Gmsh's order: (nodes, corners). Of the straight element, they
/// make its nodes.
const Eigen::MatrixXd& corner_weights(ElementKind kind, int order);

/// Numbers of the nodes of elements of one order, each once, however many elements have it. Those of the corners come
/// first: corner v is node v.
class NodeTable {
  public:
    /// @param corners  where the corners are, mm
    NodeTable(int order, std::vector<Vec3> corners);

    int order() const { return order_; }
    /// All nodes of an element, or of a face of it, in Gmsh's order. Nodes inside of solids are new at every call.
    std::vector<std::int32_t> nodes_of(ElementKind kind, const std::int32_t* corners);
    /// The nodes of an edge from a to b, with these.
    std::vector<std::int32_t> edge(std::int32_t a, std::int32_t b);

    /// Where the nodes of straight elements are.
    const std::vector<Vec3>& straight() const { return straight_; }
    std::size_t vertices() const { return vertices_; }

  private:
    /// A node by the corners that it lies between and their weights, which are whole numbers here: up to four pairs.
    using Key = std::array<std::int32_t, 8>;

    std::int32_t node(const std::vector<std::array<std::int32_t, 2>>& weights, bool shared);

    int order_;
    std::size_t vertices_;
    std::vector<Vec3> straight_;
    std::unordered_map<Key, std::int32_t, KeyHash> known_;
};

}  // namespace mq::curve

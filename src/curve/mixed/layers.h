// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/mixed/node_table.h"
#include "curve/mixed/side_rows.h"

namespace mq::curve {

/// Makes the sides of rows follow what bends their ends: the isoparametric way of Moxey, Green, Sherwin and Peiro
/// (2015), for layers of any thickness.
///
/// A whole row is one macro-element: its wall is curved, its top is straight or curved less, and it is linear from one
/// to the other. Each side gets the share of the displacement that its own fractions say, so layers are pieces of the
/// macro-element, and valid where it is. A row whose other end is inside of the mesh ends with the share `kept` of the
/// displacement: none where the row is high enough, more where the wall bends by more than a third of its height.
class Layers {
  public:
    /// @param displacement  by node: from where the side would be by itself
    Layers(NodeTable& table, const std::vector<Vec3>& displacement) : table_(table), displacement_(displacement) {}

    /// Adds what a row of edges says of the nodes of the edges between its ends.
    void add_edges(const SideRow& row);
    /// Adds what a row of faces says of the nodes inside of these, from what these deviate from their edges.
    void add_faces(const SideRow& row);
    /// Nodes with their displacement: the mean of what the rows say, weighted by the inverse squares of their heights,
    /// so that thin layers follow their walls.
    std::vector<std::pair<std::int32_t, Vec3>> result() const;

  private:
    struct Sum {
        Vec3 displacement = Vec3::Zero();
        double weight = 0.0;
    };

    void add(const SideRow& row, const std::vector<std::vector<std::int32_t>>& nodes,
             const std::vector<std::vector<double>>& fractions, const std::vector<Vec3>& first,
             const std::vector<Vec3>& last);

    NodeTable& table_;
    const std::vector<Vec3>& displacement_;
    std::unordered_map<std::int32_t, Sum> sums_;
};

}  // namespace mq::curve

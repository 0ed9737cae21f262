// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "given/mixed/node_table.h"
#include "given/mixed/side_rows.h"

namespace mq::given {

/// Bends the sides of rows with the displacements at the ends of the rows: the isoparametric method of Moxey, Green,
/// Sherwin and Peiro (2015), for layers of any thickness.
///
/// A whole row is one macro-element: its wall is curved, its top is straight or curved less, and it is linear from the
/// wall to the top. The displacement of a side is interpolated at the positions of its corners along their columns. So
/// layers are pieces of the macro-element, and valid if it is. A row whose other end is inside of the mesh keeps the
/// fraction `kept` of the displacement at that end: none if the row is high enough, more if the wall bends by more than
/// a third of its height.
class Layers {
  public:
    /// @param displacement  by node: from its position on the straight element
    Layers(NodeTable& table, const std::vector<Vec3>& displacement) : table_(table), displacement_(displacement) {}

    /// Adds the displacements that a row of edges gives to the nodes of the edges between its ends.
    void add_edges(const SideRow& row);
    /// Adds the displacements that a row of faces gives to the nodes inside of these faces, relative to the blend of
    /// their edges.
    void add_faces(const SideRow& row);
    /// Nodes with their displacements: the mean over all rows, weighted by the inverse squares of the rows' heights, so
    /// that thin layers follow their walls.
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

}  // namespace mq::given

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "tetrahedralise/cells/cell_measure.h"
#include "tetrahedralise/cells/delaunay.h"
#include "tetrahedralise/cells/flips.h"
#include "tetrahedralise/cells/tetrahedralisation.h"
#include "tetrahedralise/vertex_placing.h"

namespace mq::tetrahedralise {

/// A change that makes the worst of the cells that it touches better.
struct Change {
    bool helps = false;                     ///< whether there is a change at all
    std::vector<int> cells;                 ///< cells that are replaced, or whose vertex moves
    std::vector<std::array<int, 4>> added;  ///< their corners; -1 for the new vertex
    Vec3 place = Vec3::Zero();              ///< the new place of the vertex that moves or is inserted
    std::vector<int> read;                  ///< cells that the plan depends on: it holds until one of these changes
};

/// Looks for changes of a tetrahedralisation, which stays as it is: several threads may look at once, each with a
/// planner of its own.
class ChangePlanner {
  public:
    /// @param quality by cell
    ChangePlanner(Tetrahedralisation& mesh, const CellMeasure& measure, const std::vector<double>& quality)
        : mesh_(mesh),
          quality_(quality),
          flipper_(mesh),
          placing_(mesh, measure),
          insertion_(mesh),
          measure_(measure) {}

    /// Removes an edge of a cell, or flips one of its faces.
    void flip(int cell, Change& change);
    /// Moves an inner vertex at a poor cell.
    void move(int v, Change& change);
    /// Puts a vertex into the cavity of the middle of a poor cell, into the cells around one of its edges, or into
    /// those at one of its faces.
    void insert(int cell, Change& change);

  private:
    bool remove_one_edge(int cell, Change& change);
    bool flip_one_face(int cell);
    bool insert_near(int cell, Change& change);
    bool insert_into(const std::vector<int>& cavity, const Vec3& start, Change& change);
    bool sees_all(const Vec3& place) const;
    double quality(int cell) const { return quality_[cell]; }

    Tetrahedralisation& mesh_;
    const std::vector<double>& quality_;
    Flipper flipper_;
    VertexPlacing placing_;
    CavityInsertion insertion_;
    const CellMeasure& measure_;
    EdgeRing ring_;
    std::vector<char> seen_;
};

}  // namespace mq::tetrahedralise

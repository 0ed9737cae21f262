// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/progress.h"
#include "curve/volume/filling/cells/cell_measure.h"
#include "curve/volume/filling/cells/flips.h"
#include "curve/volume/filling/cells/tetrahedralisation.h"
#include "curve/volume/filling/delaunay.h"
#include "curve/volume/filling/vertex_placing.h"

namespace mq::curve {

/// Improves the least sine of the dihedral angles, cell by cell, by flips, by moving inner vertices and by
/// new ones; every change makes
/// the worst of the cells that it touches better (Freitag and Ollivier-Gooch 1997, Klingner and Shewchuk 2007).
class Optimisation {
  public:
    /// @param first_inner the first vertex that may move
    Optimisation(Tetrahedralisation& mesh, const EndTangents& tangents, int first_inner);

    /// @throws Cancelled
    void run(const Progress& progress);

  private:
    bool flip_cells(const Progress& progress);
    bool improve_by_flip(int cell);
    bool remove_one_edge(int cell);
    bool flip_one_face(int cell);
    bool move_vertices(const Progress& progress);
    bool move_vertex(int v);
    bool insert_vertices(const Progress& progress);
    bool insert_near(int cell);
    bool insert_into(const std::vector<int>& cavity, const Vec3& start);
    bool sees_all(const Vec3& place) const;
    void note(const std::vector<int>& changed);
    double quality(int cell) const { return quality_[cell]; }

    Tetrahedralisation& mesh_;
    CellMeasure measure_;
    Flipper flipper_;
    VertexPlacing placing_;
    CavityInsertion insertion_;
    EdgeRing ring_;
    int first_inner_;
    std::vector<double> quality_;
    std::vector<char> tried_;    // cells that no flip has helped since something around them changed
    std::vector<char> settled_;  // vertices that no move has helped since then
    std::vector<int> star_;
};

}  // namespace mq::curve

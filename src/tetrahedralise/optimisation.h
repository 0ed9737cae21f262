// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "tetrahedralise/cells/cell_measure.h"
#include "tetrahedralise/cells/tetrahedralisation.h"
#include "tetrahedralise/change_planning.h"

namespace mq::tetrahedralise {

/// Improves the least sine of the dihedral angles, cell by cell, by flips, by moving inner vertices and by
/// new ones; every change makes
/// the worst of the cells that it touches better (Freitag and Ollivier-Gooch 1997, Klingner and Shewchuk 2007).
class Optimisation {
  public:
    /// @param first_inner the first vertex that may move
    /// @param field  that edges are to be within; null: none
    Optimisation(Tetrahedralisation& mesh, const EndTangents& tangents, int first_inner,
                 const SizeField* field = nullptr);

    /// @throws Cancelled
    void run(const Progress& progress);

  private:
    template <typename Wanted, typename Plan, typename Apply>
    bool sweep(std::size_t begin, std::size_t end, const Progress& progress, const Wanted& wanted, const Plan& plan,
               const Apply& apply);
    bool flip_cells(const Progress& progress);
    bool move_vertices(const Progress& progress);
    bool insert_vertices(const Progress& progress);
    void replace(const Change& change);
    void note(const std::vector<int>& changed);
    double quality(int cell) const { return quality_[cell]; }

    Tetrahedralisation& mesh_;
    CellMeasure measure_;
    int first_inner_;
    std::vector<double> quality_;
    std::vector<ChangePlanner> planners_;  // by thread
    std::vector<char> tried_;              // by cell: no flip has helped since a cell around it changed
    std::vector<char> settled_;            // by vertex: no move has helped since then
    std::size_t block_ = 0;
    std::vector<std::size_t> changed_in_;  // by cell: the last block of plans that changed or removed it
    std::vector<int> created_;
};

}  // namespace mq::tetrahedralise

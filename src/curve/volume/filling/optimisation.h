// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "curve/volume/filling/flips.h"
#include "curve/volume/filling/tetrahedralisation.h"

namespace mq::curve {

/// Improves the least sine of the dihedral angles, cell by cell, by flips and by moving inner vertices; every change makes
/// the worst of the cells that it touches better (Freitag and Ollivier-Gooch 1997, Klingner and Shewchuk 2007).
class Optimisation {
  public:
    /// @param first_inner the first vertex that may move
    Optimisation(Tetrahedralisation& mesh, int first_inner);

    /// @throws Cancelled
    void run(const Progress& progress);

  private:
    bool flip_cells(const Progress& progress);
    bool improve_by_flip(int cell);
    bool remove_one_edge(int cell);
    bool flip_one_face(int cell);
    bool move_vertices(const Progress& progress);
    bool move_vertex(int v);
    bool try_place(int v, const Vec3& place, double& worst);
    double worst_at(int v, const Vec3& place, double enough) const;
    Vec3 uphill(int v) const;
    void note_created();
    double quality(int cell) const { return quality_[cell]; }

    Tetrahedralisation& mesh_;
    Flipper flipper_;
    int first_inner_;
    std::vector<double> quality_;
    std::vector<int> star_;
    std::vector<char> changed_;  // vertices whose surroundings have changed in this sweep
};

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "tetrahedralise/cells/cell_measure.h"
#include "tetrahedralise/cells/tetrahedralisation.h"

namespace mq::tetrahedralise {

/// Looks for the place of a vertex where the worst of its cells is best (Freitag and Ollivier-Gooch 1997). The cells
/// are given by their faces opposite the vertex, from which it is seen on the positive side.
class VertexPlacing {
  public:
    VertexPlacing(const Tetrahedralisation& mesh, const CellMeasure& measure) : mesh_(mesh), measure_(measure) {}

    std::vector<std::array<int, 3>> faces;

    /// The worst quality with the vertex at a place; no more is computed once it is not above `enough`.
    double worst_at(const Vec3& place, double enough) const;
    /// Moves the place uphill. The result is valid, exactly, if its quality is above 0.
    /// @param worst the quality at the place, before and after
    /// @return whether it has become better
    bool improve(Vec3& place, double& worst) const;

  private:
    bool try_place(Vec3& place, const Vec3& other, double& worst) const;
    bool step(Vec3& place, double length, double& worst) const;
    Vec3 uphill(const Vec3& place, double worst) const;

    const Tetrahedralisation& mesh_;
    const CellMeasure& measure_;
};

}  // namespace mq::tetrahedralise

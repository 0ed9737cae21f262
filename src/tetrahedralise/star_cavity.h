// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "tetrahedralise/cells/tetrahedralisation.h"
#include "tetrahedralise/surface_constraints.h"

namespace mq::tetrahedralise {

/// Cells that give way to those that connect one point with the faces around them. Where the point does not see a face,
/// the cell behind it joins: points meant to lie on a face or an edge hardly ever lie exactly on it.
class StarCavity {
  public:
    StarCavity(const Tetrahedralisation& mesh, const SurfaceConstraints& surface) : mesh_(mesh), surface_(surface) {}

    /// @param own the vertex whose faces are inside of the cavity, or -1
    /// @param more further faces of the cavity, such as those that replace faces with `own`
    /// @return whether the point sees all faces, and no vertex and no edge of the surface would be removed
    bool open(const Vec3& p, const std::vector<int>& start, int own, const std::vector<std::array<int, 3>>& more);

    const std::vector<int>& cells() const { return cells_; }
    /// The faces around, from which the point is seen on the positive side.
    const std::vector<std::array<int, 3>>& faces() const { return faces_; }
    /// The cells that connect the vertex with the faces.
    std::vector<std::array<int, 4>> cells_of(int vertex) const;

  private:
    enum class Step { Done, Grown, Blocked };

    Step step(const Vec3& p, int own);
    bool keeps_all(int own) const;

    const Tetrahedralisation& mesh_;
    const SurfaceConstraints& surface_;
    std::vector<int> cells_;
    std::vector<std::array<int, 3>> faces_;
};

}  // namespace mq::tetrahedralise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/sizes/size_field.h"
#include "tetrahedralise/cells/end_tangents.h"
#include "tetrahedralise/cells/tetrahedralisation.h"

namespace mq::tetrahedralise {

/// The quality of a cell once the surface is curved: the least of a fraction of the mean ratio (Liu and Joe 1994),
/// which detects cells with good angles but unequal edges, and of the sines of the dihedral angles, at its corners also
/// by the tangents of the surface's curved edges. Two edges of a smooth face that meet in an obtuse angle become nearly
/// collinear, and then no curving inside makes a tetrahedron between them valid. Cells with edges that are too long for
/// a size field are worse for it.
class CellMeasure {
  public:
    /// @param field  null: none
    CellMeasure(const Tetrahedralisation& mesh, const EndTangents& tangents, const SizeField* field = nullptr);

    /// The measure of cells with a corner that curving flattens: cells with a smaller measure are folded.
    static double folded();

    /// Positive if and only if the volume is.
    double at(const std::array<int, 4>& v) const;
    /// The measure of a face and an inner point that is no vertex yet.
    double at(const std::array<int, 3>& face, const Vec3& place) const;

  private:
    using Corners = std::array<const Vec3*, 4>;
    double value(const std::array<int, 4>& v, const Corners& p) const;
    double shape_of(const std::array<int, 4>& v, const Corners& p) const;
    double corner_sine(const std::array<int, 4>& v, const Corners& p, int corner) const;
    bool curved(int v) const { return v >= 0 && v < static_cast<int>(curved_.size()) && curved_[v] != 0; }

    const Tetrahedralisation& mesh_;
    const EndTangents& tangents_;
    const SizeField* field_;
    std::vector<char> curved_;  // vertices of curved edges
};

/// The largest length of an edge of a cell, divided by the bound that the size field at its middle sets.
double excess_of_edges(const std::array<const Vec3*, 4>& corners, const SizeField& field);
/// The length of the longest edge of a cell, divided by the bound that the least size in it sets; 0: within that.
double excess_by_least(const std::array<const Vec3*, 4>& corners, const SizeField& field);

}  // namespace mq::tetrahedralise

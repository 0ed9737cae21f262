// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/vec.h"

namespace mq {

/// The edge length that is wanted at each point of space, mm: trilinear in the leaves of an octree over a cube, and
/// beyond the cube that of its nearest point. Never changes; several threads may ask at a time.
class SizeField {
  public:
    /// Lengths at the corners of a leaf: bits 0, 1 and 2 of the index say which end in x, y and z.
    using Corners = std::array<double, 8>;

    /// @param children  by cell, the root first: index of the first of its eight children, or, for a leaf, -1 - its
    ///     index in `leaves`. Children are in the order of Corners.
    /// @param leaves  lengths above 0, mm
    /// @throws InvalidInput where cells and leaves are no octree
    SizeField(const Vec3& low, double side, std::vector<std::int32_t> children, std::vector<Corners> leaves);

    const Vec3& low() const { return low_; }
    double side() const { return side_; }
    const std::vector<std::int32_t>& children() const { return children_; }
    const std::vector<Corners>& leaves() const { return leaves_; }

    /// The wanted length at a point, mm. Time proportional to the depth of the octree.
    double at(const Vec3& point) const;
    /// The least length at any corner of a leaf that meets the box, mm; at least one leaf does.
    double least_in(const Box& box) const;
    /// The least length in the leaves at a triangle or a tetrahedron, mm, or `limit` where none is below that. Leaves
    /// are taken as spheres: some that are near count, too.
    double least_in_simplex(const std::array<Vec3, 4>& corners, int count, double limit) const;
    /// Calls `visit(low corner, side, lengths)` for the leaves that meet a box, always in the same order.
    using Visit = std::function<void(const Vec3&, double, const Corners&)>;
    void for_each_leaf(const Box& box, const Visit& visit) const;

  private:
    std::vector<double> least_by_cell() const;

    Vec3 low_;
    double side_;
    std::vector<std::int32_t> children_;
    std::vector<Corners> leaves_;
    std::vector<double> least_;  // by cell: the least length in it
};

/// The trilinear function with these values at the corners of the unit cube.
double trilinear(const SizeField::Corners& corners, const Vec3& at);

}  // namespace mq

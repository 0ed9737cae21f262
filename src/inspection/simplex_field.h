// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "geometry/box_tree.h"

namespace mq::inspection {

/// Values that are known at the corners of simplices: linear in each, and beyond them those of the nearest point.
/// Values at single points are interpolated by the distances of the nearest ones.
class SimplexField {
  public:
    /// By corner an index of a node, ascending in dimension; -1: the simplex has fewer corners.
    using Simplex = std::array<std::int32_t, 4>;

    /// @param values  by node
    /// @throws InvalidInput for a corner out of range
    SimplexField(std::vector<Vec3> nodes, const std::vector<Simplex>& simplices, std::vector<double> values);

    /// The value at a point. Time O(log n) on average.
    double at(const Vec3& point) const;
    /// The distance of a point from the nearest simplex, mm; 0 inside. Time likewise.
    double distance(const Vec3& point) const;

  private:
    /// The nearest simplex, and the coordinates of its nearest point.
    struct Nearest {
        std::size_t item = 0;
        std::array<double, 4> weights{};
        double squared_distance = 0.0;
    };
    struct Item {
        Simplex corners;
        Box box;
    };
    struct Bounds {
        Box box;
        void add(const Item& item) { box.add(item.box); }
        static Vec3 position(const Item& item) { return item.box.center(); }
    };

    Nearest nearest(const Vec3& point) const;
    double among_points(const Vec3& point) const;

    std::vector<Vec3> nodes_;
    std::vector<double> values_;
    bool only_points_;
    geometry::BoxTree<Item, Bounds> tree_;
};

/// The point of a simplex that is nearest to a point, by its barycentric coordinates; `count` corners, 1 to 4.
std::array<double, 4> nearest_of_simplex(const std::array<Vec3, 4>& corners, int count, const Vec3& point);

}  // namespace mq::inspection

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace mq {

/// A point or direction in space, mm. DontAlign: plain members of plain structs, no special allocators.
using Vec3 = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;
/// A point in a face's parameter domain (u, v).
using Vec2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

/// The cross product in the plane: twice the signed area of a triangle with these sides.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// The nearest point of single-precision numbers. GCC 12 omits some of these roundings unless its vectoriser of
/// straight-line code is off, as CMakeLists.txt has it.
inline Vec3 to_single(const Vec3& p) {
    return {static_cast<double>(static_cast<float>(p.x())), static_cast<double>(static_cast<float>(p.y())),
            static_cast<double>(static_cast<float>(p.z()))};
}
/// Whether all coordinates are single-precision numbers.
inline bool is_single(const Vec3& p) {
    return p == to_single(p);
}

/// Axis-parallel box; empty until the first point.
struct Box {
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = Vec3::Constant(-1e300);

    void add(const Vec3& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    void add(const Box& o) {
        low = low.cwiseMin(o.low);
        high = high.cwiseMax(o.high);
    }
    bool empty() const { return low.x() > high.x(); }
    /// Boxes are closed: faces, edges and corners meet too.
    bool meets(const Box& o) const {
        return (low.array() <= o.high.array()).all() && (o.low.array() <= high.array()).all();
    }
    bool contains(const Vec3& p) const { return (low.array() <= p.array()).all() && (p.array() <= high.array()).all(); }
    /// The largest dimension L of the model (Aftosmis 1999, section 4.2).
    double largest_side() const { return empty() ? 0.0 : (high - low).maxCoeff(); }
    Vec3 center() const { return 0.5 * (low + high); }
};

}  // namespace mq

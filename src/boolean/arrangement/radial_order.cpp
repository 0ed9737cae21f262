// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/radial_order.h"

#include <algorithm>

#include "base/predicates.h"
#include "boolean/arrangement/triangle_intersection.h"

namespace mq::boolean {

namespace {

/// The order about one edge, from the half-plane of the first face on.
class About {
  public:
    About(const PointTable& points, std::int32_t low, std::int32_t high, const RadialFace& first)
        : points_(points), low_(points.at(low)), high_(points.at(high)), first_(half_plane(first)) {}

    bool less(const RadialFace& a, const RadialFace& b) const {
        const int one = quarter(a);
        const int two = quarter(b);
        if (one != two) {
            return one < two;
        }
        return (one == 1 || one == 3) && a.face != b.face && side(half_plane(a), b) > 0;
    }

  private:
    /// A face's plane, the axis along which it is seen, and the orientation of (low, high, apex) seen along it.
    struct HalfPlane {
        PlanePoints plane;
        int axis = 0;
        int turn = 0;
        int turn_of_plane = 0;
    };

    HalfPlane half_plane(const RadialFace& face) const {
        HalfPlane result;
        result.plane = points_.plane(face.source);
        const auto& [a, b, c] = result.plane;
        result.axis = projection_axis(a, b, c);
        result.turn_of_plane = mq::orient2d(a, b, c, result.axis);
        result.turn = orient2d(low_, high_, points_.at(face.apex), result.axis);
        return result;
    }

    /// 1 for a face less than half a turn from the half-plane, -1 for one more than half a turn, 0 in its plane.
    int side(const HalfPlane& from, const RadialFace& face) const {
        const PlanePoints other = points_.plane(face.source);
        const auto in_plane = [&](const Vec3& p) {
            return mq::orient3d(from.plane[0], from.plane[1], from.plane[2], p) == 0;
        };
        if (std::all_of(other.begin(), other.end(), in_plane)) {
            return 0;
        }
        return from.turn * from.turn_of_plane * side_of(from.plane, points_.at(face.apex));
    }

    /// The sector of a half-plane: 0 is the first half-plane, 1 less than half a turn from it, 2 opposite, 3 more than
    /// half a turn.
    int quarter(const RadialFace& face) const {
        const int beside = side(first_, face);
        if (beside != 0) {
            return beside > 0 ? 1 : 3;
        }
        return orient2d(low_, high_, points_.at(face.apex), first_.axis) == first_.turn ? 0 : 2;
    }

    const PointTable& points_;
    ExactPoint low_;
    ExactPoint high_;
    HalfPlane first_;
};

}  // namespace

void sort_radially(const PointTable& points, std::int32_t low, std::int32_t high, std::vector<RadialFace>& faces) {
    const About about(points, low, high, faces.front());
    std::sort(faces.begin(), faces.end(), [&](const RadialFace& a, const RadialFace& b) { return about.less(a, b); });
}

}  // namespace mq::boolean

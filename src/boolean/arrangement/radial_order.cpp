// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/radial_order.h"

#include <algorithm>

namespace mq::boolean {

namespace {

/// The order about one edge, from the half-plane of the first face on.
class About {
  public:
    About(const PointTable& points, std::int32_t low, std::int32_t high, std::int32_t first)
        : points_(points), low_(points.at(low)), high_(points.at(high)), first_(first), start_(points.at(first)) {}

    /// The sector of a half-plane: 0 is the first half-plane, 1 less than half a turn from it, 2 opposite, 3 more than
    /// half a turn.
    int quarter(std::int32_t apex) const {
        if (apex == first_) {
            return 0;
        }
        const ExactPoint p = points_.at(apex);
        // Seen from high to low a counter-clockwise step has positive orientation.
        const int side = orient3d(low_, high_, start_, p);
        return side > 0 ? 1 : (side < 0 ? 3 : (same_side(p) ? 0 : 2));
    }

    bool less(std::int32_t a, std::int32_t b) const {
        const int one = quarter(a);
        const int two = quarter(b);
        if (one != two) {
            return one < two;
        }
        return (one == 1 || one == 3) && a != b && orient3d(low_, high_, points_.at(a), points_.at(b)) > 0;
    }

  private:
    /// Whether a point in the plane of the first face lies on the same side of the edge as that face.
    bool same_side(const ExactPoint& p) const {
        for (int axis = 0; axis < 3; ++axis) {
            const int first = orient2d(low_, high_, start_, axis);
            if (first != 0) {
                return first == orient2d(low_, high_, p, axis);
            }
        }
        return true;
    }

    const PointTable& points_;
    ExactPoint low_;
    ExactPoint high_;
    std::int32_t first_;
    ExactPoint start_;
};

}  // namespace

void sort_radially(const PointTable& points, std::int32_t low, std::int32_t high, std::vector<RadialFace>& faces) {
    const About about(points, low, high, faces.front().apex);
    std::sort(faces.begin(), faces.end(),
              [&](const RadialFace& a, const RadialFace& b) { return about.less(a.apex, b.apex); });
}

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/front/angular_sectors.h"

#include <algorithm>
#include <cmath>

namespace mq::triangulate {

namespace {

constexpr double kSame = 1e-7;  // Radians: rounding between two computations of the direction to one vertex.

}  // namespace

AngularSectors::AngularSectors(const Vec3& normal) : x_(normal.unitOrthogonal()), y_(normal.normalized().cross(x_)) {}

double AngularSectors::angle_of(const Vec3& direction) const {
    return std::atan2(direction.dot(y_), direction.dot(x_));
}

double AngularSectors::turn(double from, double to) {
    const double angle = to - from;
    const double wrapped = angle - 2.0 * M_PI * std::floor(angle / (2.0 * M_PI));
    return wrapped > 2.0 * M_PI - kSame ? 0.0 : wrapped;
}

bool AngularSectors::free(double from, double to) const {
    const double width = turn(from, to);
    if (width <= kSame || width >= M_PI) {
        return false;
    }
    return std::none_of(occupied_.begin(), occupied_.end(), [&](const Sector& s) {
        const double begins = turn(from, s.from);
        const double behind = turn(s.from, from);
        if (s.width <= kSame) {
            return begins > kSame && begins < width - kSame;
        }
        return begins < width - kSame || behind < s.width - kSame;
    });
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/triangle_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/predicates.h"

namespace mq::mesh {

namespace {

// Beyond these lengths, mm, squared products of two lengths overflow or vanish.
constexpr double kLong = 1e70;
constexpr double kShort = 1e-70;

struct Sides {
    std::array<Vec3, 3> side;  // the side opposite the corner of the same index
    std::array<double, 3> length;
    int shortest;
    int longest;
    double twice_area;
    bool degenerate;
    double scale = 1.0;  // what the corners were multiplied by

    /// The angle at the corner opposite a side, degrees.
    double angle_opposite(int i) const {
        return std::atan2(twice_area, -side[(i + 1) % 3].dot(side[(i + 2) % 3])) / kDegree;
    }
};

/// A power of two that makes the largest coordinate about 1.
double scale_of(const std::array<Vec3, 3>& p) {
    constexpr int kLargestPower = 1000;  // a power of two; beyond 1023 it is infinite
    double size = 0.0;
    for (const Vec3& corner : p) {
        size = std::max(size, corner.cwiseAbs().maxCoeff());
    }
    return std::ldexp(1.0, std::min(kLargestPower, -std::ilogb(size)));
}

// The cross product is taken between the two shortest sides, where the cancellation is least in a sliver.
Sides sides_of(const std::array<Vec3, 3>& p) {
    Sides s{{p[2] - p[1], p[0] - p[2], p[1] - p[0]}, {}, 0, 0, 0.0, false};
    s.length = {s.side[0].norm(), s.side[1].norm(), s.side[2].norm()};
    s.longest = static_cast<int>(std::max_element(s.length.begin(), s.length.end()) - s.length.begin());
    s.shortest = static_cast<int>(std::min_element(s.length.begin(), s.length.end()) - s.length.begin());
    const double longest = s.length[s.longest];
    const bool has_length = s.side[0] != Vec3::Zero() || s.side[1] != Vec3::Zero();
    if (longest > kLong || (longest < kShort && has_length)) {
        // Short sides may lie far from the origin: then the sides have to be scaled, not the corners.
        const Vec3 origin = longest > kLong ? Vec3(Vec3::Zero()) : p[0];
        const std::array<Vec3, 3> local{p[0] - origin, p[1] - origin, p[2] - origin};
        const double scale = scale_of(local);
        s = sides_of({local[0] * scale, local[1] * scale, local[2] * scale});
        s.scale *= scale;
        return s;
    }
    const int i = (s.longest + 1) % 3, j = (s.longest + 2) % 3;
    s.twice_area = s.side[i].cross(s.side[j]).norm();
    s.degenerate = s.length[s.shortest] == 0.0 ||
                   (s.twice_area <= 1e-10 * (s.length[i] * s.length[j]) && collinear(p[0], p[1], p[2]));
    return s;
}

}  // namespace

TriangleShape shape_of(const std::array<Vec3, 3>& p) {
    const Sides s = sides_of(p);
    const double shortest = s.length[s.shortest];
    TriangleShape shape;
    shape.aspect = shortest > 0.0 ? s.length[s.longest] / shortest : HUGE_VAL;
    shape.degenerate = s.degenerate;
    if (shape.degenerate) {
        shape.max_angle = 180.0;
        shape.distortion = HUGE_VAL;
        return shape;
    }
    shape.area = 0.5 * s.twice_area / s.scale / s.scale;
    const double squares = s.length[0] * s.length[0] + s.length[1] * s.length[1] + s.length[2] * s.length[2];
    shape.distortion = squares / (2.0 * std::sqrt(3.0) * s.twice_area);
    shape.min_angle = s.angle_opposite(s.shortest);
    shape.max_angle = s.angle_opposite(s.longest);
    return shape;
}

double min_angle_of(const std::array<Vec3, 3>& p) {
    const Sides s = sides_of(p);
    return s.degenerate ? 0.0 : s.angle_opposite(s.shortest);
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/triangle_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/predicates.h"

namespace mq::mesh {

// The cross product is taken between the two shortest sides, where it loses least in a sliver.
TriangleShape shape_of(const std::array<Vec3, 3>& p) {
    const std::array<Vec3, 3> side{p[2] - p[1], p[0] - p[2], p[1] - p[0]};
    const std::array<double, 3> length{side[0].norm(), side[1].norm(), side[2].norm()};
    const int longest = static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
    const double shortest = std::min({length[0], length[1], length[2]});
    const double twice_area = side[(longest + 1) % 3].cross(side[(longest + 2) % 3]).norm();

    TriangleShape shape;
    shape.aspect = shortest > 0.0 ? length[longest] / shortest : HUGE_VAL;
    const double scale = length[(longest + 1) % 3] * length[(longest + 2) % 3];
    shape.degenerate = shortest == 0.0 || (twice_area <= 1e-10 * scale && collinear(p[0], p[1], p[2]));
    if (shape.degenerate) {
        shape.max_angle = 180.0;
        shape.distortion = HUGE_VAL;
        return shape;
    }
    shape.area = 0.5 * twice_area;
    const double squares = length[0] * length[0] + length[1] * length[1] + length[2] * length[2];
    shape.distortion = squares / (2.0 * std::sqrt(3.0) * twice_area);
    const auto opposite = [&](int i) {
        return std::atan2(twice_area, -side[(i + 1) % 3].dot(side[(i + 2) % 3])) / kDegree;
    };
    shape.min_angle = opposite(static_cast<int>(std::min_element(length.begin(), length.end()) - length.begin()));
    shape.max_angle = opposite(longest);
    return shape;
}

}  // namespace mq::mesh

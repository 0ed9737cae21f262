// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include "geometry/parts.h"

namespace mq::triangulate {

/// A stadium of two half circles, whose sides are divided into `pieces`, of which the first is very short.
inline std::shared_ptr<geometry::Model> stadium(int pieces) {
    std::vector<TopoDS_Edge> border{geometry::arc(geometry::circle_about(5.0, 0.0, 2.0), -0.5 * M_PI, 0.5 * M_PI)};
    const auto side = [&](double from, double to, double y) {
        double last = from;
        for (int i = 0; i < pieces; ++i) {
            const double next = i + 1 == pieces ? to : from + (to - from) * 0.002 * (i + 1);
            border.push_back(geometry::line(last, y, next, y));
            last = next;
        }
    };
    side(5.0, -5.0, 2.0);
    border.push_back(geometry::arc(geometry::circle_about(-5.0, 0.0, 2.0), 0.5 * M_PI, 1.5 * M_PI));
    side(-5.0, 5.0, -2.0);
    return geometry::make_shape_model(geometry::extruded(geometry::planar_face(border), 4.0));
}

}  // namespace mq::triangulate

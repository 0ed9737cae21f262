// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/surface/curved_surface.h"

namespace mq::curve {

inline std::vector<int> invalid_triangles(const CurvedSurface& surface) {
    std::vector<int> result;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (surface.triangles[t].alive && !(surface.triangles[t].quality > 0.0)) {
            result.push_back(static_cast<int>(t));
        }
    }
    return result;
}

}  // namespace mq::curve

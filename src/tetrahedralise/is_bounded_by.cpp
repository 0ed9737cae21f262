// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/is_bounded_by.h"

#include <algorithm>

namespace mq::tetrahedralise {

namespace {

std::array<int, 3> sorted(std::array<int, 3> corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

}  // namespace

bool is_bounded_by(const std::vector<std::array<int, 3>>& surface, const std::vector<std::array<int, 4>>& tetrahedra) {
    std::vector<std::array<int, 3>> sides;
    sides.reserve(4 * tetrahedra.size() + surface.size());
    for (const auto& t : surface) {
        sides.push_back(sorted(t));
    }
    for (const auto& t : tetrahedra) {
        sides.push_back(sorted({t[0], t[1], t[2]}));
        sides.push_back(sorted({t[0], t[1], t[3]}));
        sides.push_back(sorted({t[0], t[2], t[3]}));
        sides.push_back(sorted({t[1], t[2], t[3]}));
    }
    // Together with the surface's own triangles each triangle occurs twice.
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size(); i += 2) {
        const bool single = i + 1 == sides.size() || sides[i] != sides[i + 1];
        if (single || (i + 2 < sides.size() && sides[i] == sides[i + 2])) {
            return false;
        }
    }
    return true;
}

}  // namespace mq::tetrahedralise

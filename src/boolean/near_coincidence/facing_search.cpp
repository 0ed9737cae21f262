// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/facing_search.h"

#include <algorithm>

namespace mq::boolean {

namespace {

/// The triangles whose boxes come within `reach` of the box of another operand.
std::vector<std::int32_t> near_other_operands(const Soup& soup, double reach) {
    std::vector<Box> boxes(static_cast<std::size_t>(soup.operands));
    std::vector<Box> own(soup.triangles.size());
    for (std::size_t t = 0; t < own.size(); ++t) {
        for (const std::int32_t v : soup.triangles[t]) {
            own[t].add(soup.vertices[static_cast<std::size_t>(v)]);
        }
        boxes[static_cast<std::size_t>(soup.source[t].operand)].add(own[t]);
    }
    std::vector<std::vector<Box>> common(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            const Box larger{boxes[k].low - Vec3::Constant(reach), boxes[k].high + Vec3::Constant(reach)};
            if (i != k && boxes[i].meets(larger)) {
                common[i].push_back(larger);
            }
        }
    }
    std::vector<std::int32_t> result;
    for (std::size_t t = 0; t < own.size(); ++t) {
        const std::vector<Box>& others = common[static_cast<std::size_t>(soup.source[t].operand)];
        if (std::any_of(others.begin(), others.end(), [&](const Box& box) { return box.meets(own[t]); })) {
            result.push_back(static_cast<std::int32_t>(t));
        }
    }
    return result;
}

}  // namespace

std::array<Vec3, 3> corners(const Soup& soup, std::int32_t t) {
    const Triangle& c = soup.triangles[static_cast<std::size_t>(t)];
    return {soup.vertices[static_cast<std::size_t>(c[0])], soup.vertices[static_cast<std::size_t>(c[1])],
            soup.vertices[static_cast<std::size_t>(c[2])]};
}

Box swept(const std::array<Vec3, 3>& q, double reach, double margin) {
    const Vec3 way = reach * (q[1] - q[0]).cross(q[2] - q[0]).normalized();
    Box box;
    for (const Vec3& x : q) {
        box.add(x + way);
        box.add(x - way);
    }
    return {box.low - Vec3::Constant(margin), box.high + Vec3::Constant(margin)};
}

FacingSearch::FacingSearch(const Soup& soup, double reach)
    : soup_(soup), near_(near_other_operands(soup, reach)), tree_(soup.vertices, soup.triangles, near_) {}

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/facing_search.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace mq::boolean {

namespace {

/// A superset of the triangles within `reach` of a triangle of another operand.
std::vector<std::int32_t> near_other_operands(const Soup& soup, mesh::AabbTree& all, double reach,
                                              const Progress& progress) {
    std::vector<std::int32_t> operand;
    operand.reserve(soup.source.size());
    for (const Source& source : soup.source) {
        operand.push_back(source.operand);
    }
    all.set_groups(operand);
    return all.near_other_groups(reach, &progress);
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

BoundingCircle::BoundingCircle(const std::array<Vec3, 3>& q)
    : middle((q[0] + q[1] + q[2]) / 3.0), axis((q[1] - q[0]).cross(q[2] - q[0]).normalized()) {
    for (const Vec3& x : q) {
        radius = std::max(radius, (x - middle).norm());
    }
}

FacingSearch::FacingSearch(const Soup& soup, mesh::AabbTree& all, double reach, const Progress& progress)
    : soup_(soup),
      near_(near_other_operands(soup, all, reach, progress)),
      operands_(static_cast<std::size_t>(soup.operands)) {
    for (const std::int32_t t : near_) {
        NearTriangles& own = operands_[static_cast<std::size_t>(operand_of(soup, t))];
        own.index.push_back(t);
        own.triangles.push_back(soup.triangles[static_cast<std::size_t>(t)]);
    }
    parallel_for(static_cast<int>(operands_.size()), [&](int k) {
        NearTriangles& own = operands_[static_cast<std::size_t>(k)];
        for (const std::int32_t t : own.index) {
            own.circles.emplace_back(corners(soup, t));
        }
        own.tree.emplace(soup.vertices, own.triangles);
    });
    for (std::size_t i = 0; i < operands_.size(); ++i) {
        const Box box = operands_[i].tree->box();
        const Box larger{box.low - Vec3::Constant(reach), box.high + Vec3::Constant(reach)};
        for (std::size_t k = 0; k < i; ++k) {
            if (operands_[k].tree->size() > 0 && operands_[k].tree->box().meets(larger)) {
                operands_[i].earlier.push_back(k);
            }
        }
    }
}

}  // namespace mq::boolean

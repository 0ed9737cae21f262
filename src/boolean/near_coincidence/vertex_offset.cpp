// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/vertex_offset.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "boolean/near_coincidence/tuning.h"

namespace mq::boolean {

namespace {

Vec3 normal_of(const Soup& soup, const Triangle& c) {
    const Vec3& a = soup.vertices[static_cast<std::size_t>(c[0])];
    return (soup.vertices[static_cast<std::size_t>(c[1])] - a)
        .cross(soup.vertices[static_cast<std::size_t>(c[2])] - a)
        .normalized();
}

}  // namespace

VertexOffsets::VertexOffsets(const Soup& soup)
    : operand_(soup.vertices.size(), -1),
      normal_(soup.vertices.size(), Vec3::Zero()),
      steepest_(soup.vertices.size(), 1.0) {
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const Triangle& c = soup.triangles[t];
        const Vec3 n = normal_of(soup, c);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = soup.vertices[static_cast<std::size_t>(c[k])];
            const Vec3 u = soup.vertices[static_cast<std::size_t>(c[(k + 1) % 3])] - p;
            const Vec3 v = soup.vertices[static_cast<std::size_t>(c[(k + 2) % 3])] - p;
            operand_[static_cast<std::size_t>(c[k])] = soup.source[t].operand;
            normal_[static_cast<std::size_t>(c[k])] += angle_between(u, v) * n;
        }
    }
    for (Vec3& n : normal_) {
        n.normalize();
    }
    for (const Triangle& c : soup.triangles) {
        const Vec3 n = normal_of(soup, c);
        for (const std::int32_t v : c) {
            const auto i = static_cast<std::size_t>(v);
            steepest_[i] = std::min(steepest_[i], n.dot(normal_[i]));
        }
    }
}

Vec3 VertexOffsets::at(std::size_t v) const {
    return normal_[v] / std::max(steepest_[v], NearCoincidenceTuning::kLeastOffsetCosine);
}

}  // namespace mq::boolean

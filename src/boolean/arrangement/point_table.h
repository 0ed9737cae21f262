// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/key_set.h"
#include "boolean/arrangement/soup.h"
#include "boolean/exact/exact_point.h"

namespace mq::boolean {

/// An edge by its vertices, the lower first.
using EdgeKey = std::array<std::int32_t, 2>;

inline EdgeKey edge_key(std::int32_t a, std::int32_t b) {
    return a < b ? EdgeKey{a, b} : EdgeKey{b, a};
}

/// The points of an arrangement by index: first the soup's vertices, then the constructed ones.
class PointTable {
  public:
    explicit PointTable(const Soup& soup) : soup_(soup), given_(static_cast<std::int32_t>(soup.vertices.size())) {}

    std::int32_t size() const { return given_ + static_cast<std::int32_t>(constructed_.size()); }
    bool given(std::int32_t point) const { return point < given_; }
    ExactPoint at(std::int32_t point) const {
        return given(point) ? ExactPoint(vertex(point)) : constructed_[static_cast<std::size_t>(point - given_)];
    }
    Vec3 approx(std::int32_t point) const {
        return given(point) ? vertex(point) : constructed_[static_cast<std::size_t>(point - given_)].approx();
    }
    PlanePoints plane(std::int32_t triangle) const;

    /// Where the edge meets the triangle's inside.
    std::int32_t on_face(EdgeKey edge, std::int32_t triangle);
    /// Where two edges that are not parallel cross; `plane` holds `other` and does not hold `edge`.
    std::int32_t on_edges(EdgeKey edge, EdgeKey other, const PlanePoints& plane);
    std::int32_t add(ExactPoint&& point);

    /// Gives one index to each place in space: canonical[i] is the lowest index of the points that coincide with point
    /// i. The constructed points and some of the soup's vertices are compared.
    /// @param vertices  those with which constructed points may coincide: all that lie on edges or in faces
    std::vector<std::int32_t> canonical(std::vector<std::int32_t> vertices = {}) const;

  private:
    const Vec3& vertex(std::int32_t v) const { return soup_.vertices[static_cast<std::size_t>(v)]; }
    std::int32_t made(std::array<std::int32_t, 4> key, const EdgeKey& edge, const PlanePoints& plane);

    const Soup& soup_;
    std::int32_t given_;
    std::vector<ExactPoint> constructed_;
    std::unordered_map<std::array<std::int32_t, 4>, std::int32_t, KeyHash> known_;
};

}  // namespace mq::boolean

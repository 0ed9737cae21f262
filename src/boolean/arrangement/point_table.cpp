// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/point_table.h"

#include <algorithm>
#include <numeric>

namespace mq::boolean {

PlanePoints PointTable::plane(std::int32_t triangle) const {
    const Triangle& t = soup_.triangles[static_cast<std::size_t>(triangle)];
    return {vertex(t[0]), vertex(t[1]), vertex(t[2])};
}

std::int32_t PointTable::add(ExactPoint&& point) {
    constructed_.push_back(std::move(point));
    return size() - 1;
}

std::int32_t PointTable::made(std::array<std::int32_t, 4> key, const EdgeKey& edge, const PlanePoints& plane) {
    const auto [found, fresh] = known_.emplace(key, size());
    if (fresh) {
        constructed_.push_back(ExactPoint::on_line(vertex(edge[0]), vertex(edge[1]), plane));
    }
    return found->second;
}

std::int32_t PointTable::on_face(EdgeKey edge, std::int32_t triangle) {
    return made({edge[0], edge[1], triangle, -1}, edge, plane(triangle));
}

std::int32_t PointTable::on_edges(EdgeKey edge, EdgeKey other, const PlanePoints& plane) {
    const EdgeKey& low = std::min(edge, other);
    const EdgeKey& high = std::max(edge, other);
    return made({low[0], low[1], high[0], high[1]}, edge, plane);
}

std::vector<std::int32_t> PointTable::canonical(std::vector<std::int32_t> vertices) const {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<std::int32_t> order = std::move(vertices);
    order.resize(order.size() + constructed_.size());
    std::iota(order.end() - static_cast<std::ptrdiff_t>(constructed_.size()), order.end(), given_);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        const double x = approx(a).x();
        const double y = approx(b).x();
        return x != y ? x < y : a < b;
    });
    double error = 0.0;
    for (const ExactPoint& p : constructed_) {
        error = std::max(error, p.error());
    }
    std::vector<std::int32_t> result(static_cast<std::size_t>(size()));
    std::iota(result.begin(), result.end(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Vec3 here = approx(order[i]);
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Vec3 gap = (approx(order[j]) - here).cwiseAbs();
            if (gap.x() > 4.0 * error) {
                break;
            }
            if (gap.maxCoeff() <= 4.0 * error && coincide(at(order[i]), at(order[j]))) {
                std::int32_t& low = result[static_cast<std::size_t>(std::max(order[i], order[j]))];
                low = std::min(low, result[static_cast<std::size_t>(std::min(order[i], order[j]))]);
            }
        }
    }
    return result;
}

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/point_table.h"

#include <algorithm>
#include <limits>
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
    // Positions along a skew direction: along an axis, all points of a face perpendicular to it would have one
    // position.
    const Vec3 skew(0.6086, 0.5257, 0.5943);
    std::vector<double> along(static_cast<std::size_t>(size()));
    double error = 0.0;
    double largest = 0.0;
    for (const std::int32_t p : order) {
        largest = std::max(largest, approx(p).cwiseAbs().maxCoeff());
        along[static_cast<std::size_t>(p)] = skew.dot(approx(p));
        error = std::max(error, given(p) ? 0.0 : constructed_[static_cast<std::size_t>(p - given_)].error());
    }
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        const double x = along[static_cast<std::size_t>(a)];
        const double y = along[static_cast<std::size_t>(b)];
        return x != y ? x < y : a < b;
    });
    // Coinciding points are within two errors along each axis, and so within four along the direction. The sums of two
    // places of three products each are rounded by less than 6 epsilon times the largest coordinate.
    const double reach = 4.0 * error + 6.0 * std::numeric_limits<double>::epsilon() * largest;
    std::vector<std::int32_t> result(static_cast<std::size_t>(size()));
    std::iota(result.begin(), result.end(), 0);
    // Each point is compared with the first of a set of coinciding points only, since such sets are large where many
    // planes meet.
    std::vector<char> found(order.size(), 0);
    std::vector<std::int32_t> same;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (found[i] != 0) {
            continue;
        }
        const Vec3 here = approx(order[i]);
        const double place = along[static_cast<std::size_t>(order[i])];
        same.assign(1, order[i]);
        for (std::size_t j = i + 1; j < order.size() && along[static_cast<std::size_t>(order[j])] - place <= reach;
             ++j) {
            const Vec3 gap = (approx(order[j]) - here).cwiseAbs();
            if (found[j] == 0 && gap.maxCoeff() <= 4.0 * error && coincide(at(order[i]), at(order[j]))) {
                found[j] = 1;
                same.push_back(order[j]);
            }
        }
        const std::int32_t low = *std::min_element(same.begin(), same.end());
        for (const std::int32_t p : same) {
            result[static_cast<std::size_t>(p)] = low;
        }
    }
    return result;
}

}  // namespace mq::boolean

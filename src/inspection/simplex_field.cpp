// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/simplex_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::inspection {

namespace {

using Weights = std::array<double, 4>;

constexpr std::size_t kLeaf = 8;    // items in a leaf of the tree
constexpr std::size_t kAround = 8;  // points of which a value is interpolated

int corner_count(const SimplexField::Simplex& simplex) {
    return static_cast<int>(std::find(simplex.begin(), simplex.end(), -1) - simplex.begin());
}

Vec3 combined(const std::array<Vec3, 4>& corners, int count, const Weights& weights) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < count; ++i) {
        sum += weights[static_cast<std::size_t>(i)] * corners[static_cast<std::size_t>(i)];
    }
    return sum;
}

// The barycentric coordinates of the projection of a point onto the space that a simplex spans; not numbers where its
// corners are not independent.
Weights coordinates(const std::array<Vec3, 4>& corners, int count, const Vec3& point) {
    const Vec3 p = point - corners[0];
    const Vec3 a = corners[1] - corners[0];
    if (count == 2) {
        const double t = p.dot(a) / a.squaredNorm();
        return {1.0 - t, t, 0.0, 0.0};
    }
    const Vec3 b = corners[2] - corners[0];
    const Vec3 normal = a.cross(b);
    if (count == 3) {
        const double s = p.cross(b).dot(normal) / normal.squaredNorm();
        const double t = a.cross(p).dot(normal) / normal.squaredNorm();
        return {1.0 - s - t, s, t, 0.0};
    }
    const Vec3 c = corners[3] - corners[0];
    const double volume = normal.dot(c);
    const double s = p.dot(b.cross(c)) / volume;
    const double t = p.dot(c.cross(a)) / volume;
    const double u = p.dot(normal) / volume;
    return {1.0 - s - t - u, s, t, u};
}

}  // namespace

// Where the projection lies outside, the nearest point lies on a side that the projection is beyond.
std::array<double, 4> nearest_of_simplex(const std::array<Vec3, 4>& corners, int count, const Vec3& point) {
    if (count == 1) {
        return {1.0, 0.0, 0.0, 0.0};
    }
    const Weights inside = coordinates(corners, count, point);
    if (std::all_of(inside.begin(), inside.begin() + count, [](double w) { return w >= 0.0; })) {
        return inside;
    }
    Weights best{};
    double least = std::numeric_limits<double>::infinity();
    for (int left_out = 0; left_out < count; ++left_out) {
        std::array<Vec3, 4> side = corners;
        std::copy(corners.begin() + left_out + 1, corners.begin() + count, side.begin() + left_out);
        const Weights of_side = nearest_of_simplex(side, count - 1, point);
        const double distance = (combined(side, count - 1, of_side) - point).squaredNorm();
        if (distance < least) {
            least = distance;
            best = {};
            for (int i = 0; i + 1 < count; ++i) {
                best[static_cast<std::size_t>(i < left_out ? i : i + 1)] = of_side[static_cast<std::size_t>(i)];
            }
        }
    }
    return best;
}

SimplexField::SimplexField(std::vector<Vec3> nodes, const std::vector<Simplex>& simplices, std::vector<double> values)
    : nodes_(std::move(nodes)), values_(std::move(values)), only_points_(true) {
    const auto count = static_cast<std::int32_t>(nodes_.size());
    for (const Simplex& simplex : simplices) {
        Item item{simplex, {}};
        const int corners = corner_count(simplex);
        only_points_ = only_points_ && corners == 1;
        for (int i = 0; i < corners; ++i) {
            const std::int32_t v = simplex[static_cast<std::size_t>(i)];
            if (v < 0 || v >= count) {
                throw InvalidInput(phrases::kNoSuchVertex,
                                   {{"count", tree_.items.size()}, {"count2", v}, {"count3", count}});
            }
            item.box.add(nodes_[static_cast<std::size_t>(v)]);
        }
        tree_.items.push_back(item);
    }
    tree_.build(kLeaf);
}

double SimplexField::at(const Vec3& point) const {
    if (only_points_) {
        return among_points(point);
    }
    const Nearest found = nearest(point);
    const Simplex& corners = tree_.items[found.item].corners;
    double value = 0.0;
    for (std::size_t k = 0; k < 4 && corners[k] >= 0; ++k) {
        value += found.weights[k] * values_[static_cast<std::size_t>(corners[k])];
    }
    return value;
}

double SimplexField::distance(const Vec3& point) const {
    return std::sqrt(nearest(point).squared_distance);
}

SimplexField::Nearest SimplexField::nearest(const Vec3& point) const {
    Nearest best;
    best.squared_distance = std::numeric_limits<double>::infinity();
    const auto lowest = [&](const Bounds& bounds) { return geometry::gap(bounds.box, point).squaredNorm(); };
    tree_.search(best.squared_distance, lowest, [&](std::size_t i) {
        const Item& item = tree_.items[i];
        if (geometry::gap(item.box, point).squaredNorm() >= best.squared_distance) {
            return;
        }
        const int count = corner_count(item.corners);
        std::array<Vec3, 4> corners{};
        for (int k = 0; k < count; ++k) {
            corners[static_cast<std::size_t>(k)] =
                nodes_[static_cast<std::size_t>(item.corners[static_cast<std::size_t>(k)])];
        }
        const Weights weights = nearest_of_simplex(corners, count, point);
        const double squared = (combined(corners, count, weights) - point).squaredNorm();
        if (squared < best.squared_distance) {
            best = {i, weights, squared};
        }
    });
    return best;
}

// The weights of Franke and Little: ((R - d) / (R d))^2 at the distance d, where R is that of the first point left out.
double SimplexField::among_points(const Vec3& point) const {
    std::vector<std::pair<double, std::int32_t>> found;  // the nearest ones, ascending
    double limit = std::numeric_limits<double>::infinity();
    const auto lowest = [&](const Bounds& bounds) { return geometry::gap(bounds.box, point).squaredNorm(); };
    tree_.search(limit, lowest, [&](std::size_t i) {
        const std::int32_t node = tree_.items[i].corners[0];
        const std::pair<double, std::int32_t> next{(nodes_[static_cast<std::size_t>(node)] - point).squaredNorm(),
                                                   node};
        found.insert(std::upper_bound(found.begin(), found.end(), next), next);
        if (found.size() > kAround + 1) {
            found.pop_back();
            limit = found.back().first;
        }
    });
    const auto value = [&](std::size_t i) { return values_[static_cast<std::size_t>(found[i].second)]; };
    const double reach = found.size() > kAround ? std::sqrt(found.back().first)
                                                : 2.0 * std::sqrt(found.empty() ? 0.0 : found.back().first);
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < std::min(found.size(), kAround); ++i) {
        const double distance = std::sqrt(found[i].first);
        if (distance == 0.0) {
            return value(i);
        }
        const double root = (reach - distance) / (reach * distance);
        sum += root * root * value(i);
        weights += root * root;
    }
    return weights > 0.0 ? sum / weights : found.empty() ? 0.0 : value(0);
}

}  // namespace mq::inspection

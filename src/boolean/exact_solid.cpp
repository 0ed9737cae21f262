// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/exact_solid.h"

#include <algorithm>
#include <limits>

#include "base/predicates.h"

namespace mq::boolean {

namespace {

using mesh::Triangle;

/// The side on which an edge passes a line along an axis: positive where it runs counter-clockwise around it, seen
/// against the axis. The line is moved by an infinitesimal vector, the same for all edges, so that it meets none.
int side_of_edge(const Vec3& p, const Vec3& v, const Vec3& w, int axis) {
    const int side = orient2d(p, v, w, axis);
    if (side != 0) {
        return side;
    }
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    if (v[j] != w[j]) {
        return v[j] > w[j] ? 1 : -1;
    }
    return v[i] < w[i] ? 1 : v[i] > w[i] ? -1 : 0;
}

}  // namespace

bool ExactSolid::contains(const Vec3& p) const {
    const Box box = tree_.box();
    int axis = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const double way = std::min(p[k] - box.low[k], box.high[k] - p[k]);
        if (way < 0.0) {
            return false;
        }
        if (way < shortest) {
            shortest = way;
            axis = k;
        }
    }
    return sides(p, axis, 0.0)[0];
}

std::array<bool, 2> ExactSolid::sides(const Vec3& p, int axis, double half) const {
    const Box box = tree_.box();
    const double sign = box.high[axis] - p[axis] < p[axis] - box.low[axis] ? 1.0 : -1.0;
    Vec3 along = Vec3::Zero();
    along[axis] = sign;
    std::vector<std::int32_t> beyond(operands_.size(), 0);
    std::vector<std::int32_t> between(operands_.size(), 0);
    // The ray as a box without a width, which costs less than the test for rays of any direction.
    Box ray;
    ray.add(p - 2.0 * half * along);
    ray.add(p);
    ray.low[axis] = sign > 0.0 ? ray.low[axis] : std::min(ray.low[axis], box.low[axis]);
    ray.high[axis] = sign > 0.0 ? std::max(ray.high[axis], box.high[axis]) : ray.high[axis];
    tree_.for_each_in_box(ray, [&](std::int32_t triangle) {
        const auto operand = static_cast<std::size_t>(operand_[static_cast<std::size_t>(triangle)]);
        if (operands_[operand].winding != nullptr) {
            return;
        }
        const auto [a, b, c] = corners(triangle);
        const int side = side_of_edge(p, a, b, axis);
        if (side == 0 || side_of_edge(p, b, c, axis) != side || side_of_edge(p, c, a, axis) != side) {
            return;
        }
        const Vec3 normal = (b - a).cross(c - a);
        double at = p[axis];
        if (normal[axis] != 0.0) {
            Vec3 in_plane = a - p;
            in_plane[axis] = 0.0;
            at = a[axis] + in_plane.dot(normal) / normal[axis];
        }
        const auto [low, high] = std::minmax({a[axis], b[axis], c[axis]});
        const double ahead = sign * (std::clamp(at, low, high) - p[axis]);
        const int turns = sign > 0.0 ? side : -side;
        if (ahead > half) {
            beyond[operand] += turns;
        } else if (ahead > -half) {
            between[operand] += turns;
        }
    });
    for (std::size_t k = 0; k < operands_.size(); ++k) {
        between[k] += beyond[k];
        if (operands_[k].winding != nullptr) {
            beyond[k] = guesses_inside(k, p + half * along) ? 1 : 0;
            between[k] = half > 0.0 ? (guesses_inside(k, p - half * along) ? 1 : 0) : beyond[k];
        }
    }
    return {expression_.contains(between.data()), expression_.contains(beyond.data())};
}

bool ExactSolid::is_bounded_at(const Vec3& p, const Vec3& normal, double beside) const {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const auto [before, behind] = sides(p, axis, beside);
    return before != behind;
}

bool ExactSolid::is_thick_at(const Vec3& p, double diameter) const {
    return has_ball(p, true, 0.5 * diameter) && has_ball(p, false, 0.5 * diameter);
}

void ExactSolid::add_steps_to_guess(const Vec3& p, std::vector<Vec3>& steps) const {
    for (const EnclosedOperand& operand : operands_) {
        if (operand.winding == nullptr) {
            continue;
        }
        const Vec3 gradient = operand.winding->gradient(p);
        if (gradient.squaredNorm() > 0.0) {
            steps.emplace_back((0.5 - operand.winding->at(p)) / gradient.squaredNorm() * gradient);
        }
        const Box box = operand.winding->tree().box();
        for (int k = 0; k < 3; ++k) {
            steps.emplace_back((box.low[k] - p[k]) * Vec3::Unit(k));
            steps.emplace_back((box.high[k] - p[k]) * Vec3::Unit(k));
        }
    }
}

bool ExactSolid::has_ball(const Vec3& p, bool inside, double radius) const {
    bool found = false;
    for (double way = radius; way <= 2.0 * radius && !found; way += radius) {
        for_each_way(way, [&](const Vec3& step) {
            found = contains(p + step) == inside;
            for_each_way(radius, [&](const Vec3& around) {
                found = found && contains(p + step + around) == inside;
                return found;
            });
            return !found;
        });
    }
    return found;
}

bool ExactSolid::guesses_inside(std::size_t operand, const Vec3& p) const {
    const mesh::SurfaceWinding& winding = *operands_[operand].winding;
    return winding.tree().box().contains(p) && winding.at(p) >= 0.5;
}

std::vector<Triangle> ExactSolid::merge() {
    std::vector<Triangle> all;
    for (std::size_t k = 0; k < operands_.size(); ++k) {
        const auto first = static_cast<std::int32_t>(vertices_.size());
        first_.push_back(static_cast<std::int32_t>(all.size()));
        vertices_.insert(vertices_.end(), operands_[k].vertices->begin(), operands_[k].vertices->end());
        for (const Triangle& t : *operands_[k].triangles) {
            all.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
        operand_.resize(all.size(), static_cast<std::int32_t>(k));
    }
    return all;
}

}  // namespace mq::boolean

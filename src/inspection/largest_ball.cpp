// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/largest_ball.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/tuning.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::inspection {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// The radius is found when it changes by less than this fraction.
constexpr double kSettled = 1e-10;

/// How deep a ball may cut into the surface near the point where it starts (within 60 degrees of it, seen from the
/// centre), as a fraction of the radius. On a solid bar of 12 facets this depth is 0.14.
constexpr double kLargestCutNearby = 0.2;
/// How deep a ball may cut into the surface elsewhere, as a fraction of the radius.
constexpr double kLargestCut = 0.02;

/// A point counts as touched if its distance from the ball is at most this fraction of the radius. Beside a tangent
/// plane such points lie up to 11 degrees off the contact, seen from the centre.
constexpr double kLargestGap = 0.02;
/// If the distance of a contact is at most this fraction of the radius, no nearer one is searched.
constexpr double kSmallGap = 0.002;

/// The greatest component along an axis of the unit vectors within `angle` of a direction whose component is `cosine`.
double most_along(double cosine, double angle) {
    const double between = std::acos(std::clamp(cosine, -1.0, 1.0));
    return between <= angle ? 1.0 : std::cos(between - angle);
}

}  // namespace

bool FreeBalls::contain(const Vec3& center, double radius) const {
    return std::any_of(balls_.begin(), balls_.end(), [&](const Ball& ball) {
        return ball.radius >= radius && (ball.center - center).norm() + radius <= ball.radius;
    });
}

void FreeBalls::add(const Vec3& center, double radius) {
    balls_[next_] = {center, radius};
    next_ = (next_ + 1) % balls_.size();
}

LargestBall largest_ball(const mesh::NearestTree& tree, const Vec3& point, const Vec3& direction, double allowance,
                         double ahead, std::int32_t triangle_ahead, FreeBalls& known) {
    LargestBall ball;
    const Box box = tree.box();
    const bool limited = std::isfinite(ahead);
    ball.radius = limited ? 0.5 * ahead : 2.0 * (box.high - box.low).norm();
    ball.contact = point + (limited ? ahead : 0.0) * direction;
    ball.triangle = triangle_ahead;
    for (int round = 0; round < kMostSteps; ++round) {
        ball.center = point + ball.radius * direction;
        const double least = ball.radius - std::min(allowance, kLargestCut * ball.radius);
        const double least_nearby = ball.radius - std::min(allowance, kLargestCutNearby * ball.radius);
        if (known.contain(ball.center, least)) {
            break;
        }
        const mesh::ClosestPoint nearest = tree.nearest(ball.center, ball.radius);
        known.add(ball.center, std::min(nearest.distance, ball.radius));
        const bool is_nearby = (ball.center - nearest.point).dot(direction) >= 0.5 * nearest.distance;
        if (nearest.distance >= (is_nearby ? least_nearby : least) * (1.0 - kSettled)) {
            break;
        }
        // The ball that touches the surface at the nearest point as well.
        const Vec3 to = nearest.point - point;
        const double depth = to.dot(direction);
        const double radius = depth > 0.0 ? 0.5 * to.squaredNorm() / depth : 0.0;
        if (!(radius < ball.radius)) {
            break;
        }
        ball.radius = std::max(radius, 0.0);
        ball.contact = nearest.point;
        ball.triangle = nearest.triangle;
    }
    ball.center = point + ball.radius * direction;
    if (ball.triangle < 0) {
        ball.radius = kInfinite;
    }
    return ball;
}

OppositeContact opposite_contact(const mesh::NearestTree& tree, const std::vector<Vec3>& vertices,
                                 const std::vector<mesh::Triangle>& triangles, const LargestBall& ball,
                                 const Vec3& direction, double angle) {
    const double reach = (1.0 + kLargestGap) * ball.radius;
    const double least = std::cos(angle);
    const auto touches = [&](const Vec3& q) {
        const Vec3 to = q - ball.center;
        const double distance = to.norm();
        return distance <= reach && to.dot(direction) >= least * distance;
    };
    if (ball.triangle < 0 || touches(ball.contact)) {
        return {ball.triangle, ball.triangle >= 0 ? (ball.contact - ball.center).norm() : 0.0};
    }
    Box cap;
    for (int i = 0; i < 3; ++i) {
        cap.low[i] = ball.center[i] - reach * std::max(most_along(-direction[i], angle), 0.0);
        cap.high[i] = ball.center[i] + reach * std::max(most_along(direction[i], angle), 0.0);
    }
    OppositeContact found;
    tree.for_each_in_box(cap, [&](std::int32_t triangle) {
        const mesh::Triangle& t = triangles[triangle];
        const Vec3 q = mesh::nearest_on_triangle(ball.center, vertices[t[0]], vertices[t[1]], vertices[t[2]]);
        const double distance = (q - ball.center).norm();
        const bool is_nearer = found.triangle < 0 || distance < found.distance;
        if (is_nearer && touches(q)) {
            found = {triangle, distance};
        }
        return found.triangle < 0 || found.distance > (1.0 + kSmallGap) * ball.radius;
    });
    return found;
}

}  // namespace mq::inspection

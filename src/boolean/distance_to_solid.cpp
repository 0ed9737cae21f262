// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/distance_to_solid.h"

#include <algorithm>
#include <cstdint>

#include "mesh/intersection/triangle_distance.h"

namespace mq::boolean {

namespace {

using Corners = std::array<Vec3, 3>;

}  // namespace

double DistanceToSolid::bound(double enough) {
    const mesh::ClosestPoint near = solid_.tree().nearest(p_);
    if (near.triangle < 0) {
        return 0.0;  // no operand has a triangle, so that there is nothing to compare
    }
    const double least = kLeastBound * solid_.beside();  // bound on the distance of the points that lies_on() tests
    if (near.distance <= 2.0 * solid_.beside() && lies_on()) {
        return least;
    }
    inside_ = solid_.contains(p_);
    const Box box = solid_.tree().box();
    const double whole = (box.high - box.low).norm() + near.distance;
    best_ = whole;
    try_step(near.point - p_);
    std::vector<Vec3> guesses;
    solid_.add_steps_to_guess(p_, guesses);
    for (const Vec3& step : guesses) {
        try_step(step);
    }
    if (best_ > enough && is_any_beyond(enough)) {
        return enough;
    }
    double searched = 0.0;
    for (double reach = kWider * (near.distance + solid_.beside()); best_ > enough && searched < best_;
         reach *= kWider) {
        search(searched, std::min(reach, best_));
        if (best_ > reach) {
            probe(reach);
        }
        searched = reach;
    }
    return best_;
}

bool DistanceToSolid::lies_on() const {
    const Vec3 around = Vec3::Constant(2.0 * solid_.beside());
    bool found = false;
    solid_.tree().for_each_in_box({p_ - around, p_ + around}, [&](std::int32_t triangle) {
        const Corners corners = solid_.corners(triangle);
        const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        const Vec3 at = mesh::nearest_on_triangle(p_, corners[0], corners[1], corners[2]);
        if ((at - p_).norm() > 2.0 * solid_.beside()) {
            return true;
        }
        found = solid_.is_bounded_at(at, normal);
        for (std::size_t k = 0; k < 3 && !found; ++k) {
            const Vec3 way = corners[k] - at;
            const double share = std::min(1.0, 4.0 * solid_.beside() / std::max(way.norm(), solid_.beside()));
            found = solid_.is_bounded_at(at + share * way, normal);
        }
        return !found;
    });
    return found;
}

bool DistanceToSolid::try_step(const Vec3& step) {
    const double length = step.norm();
    if (length == 0.0) {
        return false;
    }
    for (const double factor : kBeyond) {
        const double far = factor * length + 2.0 * solid_.beside();
        if (far >= best_) {
            return false;
        }
        if (solid_.contains(p_ + far / length * step) != inside_) {
            best_ = far;
            return true;
        }
    }
    return false;
}

bool DistanceToSolid::try_around(const Vec3& step) {
    const Vec3 ahead = step.normalized();
    const Vec3 across = ahead.unitOrthogonal();
    const Vec3 third = ahead.cross(across);
    const double little = 4.0 * solid_.beside();
    for (const double i : {-little, little}) {
        for (const double j : {-little, little}) {
            const Vec3 there = step + little * ahead + i * across + j * third;
            if (there.norm() < best_ && solid_.contains(p_ + there) != inside_) {
                best_ = there.norm();
                return true;
            }
        }
    }
    return false;
}

void DistanceToSolid::search(double searched, double reach) {
    const std::vector<Vec3> steps = steps_within(reach);
    std::size_t tried = 0;
    for (const Vec3& step : steps) {
        if (step.norm() < searched) {
            continue;
        }
        if (++tried > kMostSteps || step.norm() >= best_ || try_step(step) ||
            (tried <= kMostAround && try_around(step))) {
            break;
        }
    }
    const std::vector<Vec3> apart = steps_apart(steps, kNear * reach);
    for (std::size_t i = 0; i < apart.size(); ++i) {
        for (std::size_t j = i + 1; j < apart.size(); ++j) {
            try_to_meet({&apart[i], &apart[j]});
            for (std::size_t k = j + 1; k < std::min(apart.size(), kMostInThrees); ++k) {
                try_to_meet({&apart[i], &apart[j], &apart[k]});
            }
        }
    }
}

bool DistanceToSolid::is_any_beyond(double distance) const {
    bool found = false;
    for_each_way(distance, [&](const Vec3& step) {
        found = solid_.contains(p_ + step) != inside_;
        return !found;
    });
    return found;
}

void DistanceToSolid::probe(double radius) {
    for_each_way(radius, [&](const Vec3& step) {
        if (solid_.contains(p_ + step) != inside_) {
            shorten(step);
        }
        return true;
    });
}

void DistanceToSolid::shorten(const Vec3& step) {
    constexpr int kHalvings = 7;  // to a hundredth
    double from = 0.0;
    double to = 1.0;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (from + to);
        (solid_.contains(p_ + middle * step) == inside_ ? from : to) = middle;
    }
    best_ = std::min(best_, to * step.norm());
}

std::vector<Vec3> DistanceToSolid::steps_within(double reach) const {
    std::vector<Vec3> all;
    const Vec3 around = Vec3::Constant(reach);
    solid_.tree().for_each_in_box({p_ - around, p_ + around}, [&](std::int32_t triangle) {
        const auto [a, b, c] = solid_.corners(triangle);
        const Vec3 step = mesh::nearest_on_triangle(p_, a, b, c) - p_;
        if (step.norm() <= reach) {
            all.push_back(step);
        }
    });
    std::sort(all.begin(), all.end(), [](const Vec3& a, const Vec3& b) { return a.squaredNorm() < b.squaredNorm(); });
    return all;
}

std::vector<Vec3> DistanceToSolid::steps_apart(const std::vector<Vec3>& steps, double least) {
    std::vector<Vec3> apart;
    for (const Vec3& step : steps) {
        if (step.norm() < least) {
            continue;
        }
        if (apart.size() == kMostInPairs) {
            break;
        }
        const double near = kSame * step.norm();
        const auto is_near = [&](const Vec3& other) { return (other - step).norm() <= near; };
        if (std::none_of(apart.begin(), apart.end(), is_near)) {
            apart.push_back(step);
        }
    }
    return apart;
}

}  // namespace mq::boolean

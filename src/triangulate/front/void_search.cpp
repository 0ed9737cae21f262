// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/front/void_search.h"

#include <algorithm>
#include <cmath>

#include "triangulate/front/tuning.h"

namespace mq::triangulate {

namespace {

// Height of a triangle over its longest side: below it the triangle has no area within rounding.
constexpr double kFlat = 1e-9;
constexpr unsigned kAll = 7;  // bit mask of all three corners

int longest_side(const Triangle2& t) {
    const double sides[3] = {(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()};
    return static_cast<int>(std::max_element(sides, sides + 3) - sides);
}

double length(const Triangle2& t, int side) {
    return (t[(side + 1) % 3] - t[side]).norm();
}

std::array<Triangle2, 2> halves(const Triangle2& t) {
    const int i = longest_side(t);
    const Vec2& from = t[i];
    const Vec2& to = t[(i + 1) % 3];
    const Vec2& apex = t[(i + 2) % 3];
    const Vec2 middle = 0.5 * (from + to);
    return {{{from, middle, apex}, {middle, to, apex}}};
}

Vec2 dart(const Triangle2& t, std::mt19937_64& random) {
    double a = uniform(random);
    double b = uniform(random);
    if (a + b > 1.0) {
        a = 1.0 - a;
        b = 1.0 - b;
    }
    return t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
}

}  // namespace

VoidSearch::VoidSearch(const std::array<Vec3, 3>& triangle, const std::array<double, 3>& radii,
                       const std::vector<Ball>& balls, const Outline& outline) {
    const Vec3 first = triangle[1] - triangle[0];
    const Vec3 second = triangle[2] - triangle[0];
    const double width = first.norm();
    const Vec3 normal = first.cross(second);
    const double longest = std::max({width, second.norm(), (triangle[2] - triangle[1]).norm()});
    if (!(normal.norm() > kFlat * longest * longest)) {
        return;
    }
    size_ = longest;
    const Vec3 x = first / width;
    const Vec3 z = normal.normalized();
    const Vec3 y = z.cross(x);
    whole_ = {Vec2::Zero(), Vec2(width, 0.0), Vec2(second.dot(x), second.dot(y))};
    radius_ = radii[0];
    growth_.x() = (radii[1] - radii[0]) / width;
    growth_.y() = (radii[2] - radii[0] - growth_.x() * whole_[2].x()) / whole_[2].y();
    for (const Ball& ball : balls) {
        const Vec3 arm = ball.centre - triangle[0];
        const double height = arm.dot(z);
        discs_.push_back({Vec2(arm.dot(x), arm.dot(y)), height * height, ball.radius});
    }
    outline_.reference = in_plane(outline.reference);
    outline_.inside = outline.inside;
    for (const Segment2& s : outline.segments) {
        outline_.segments.push_back({in_plane(s[0]), in_plane(s[1])});
    }
}

bool VoidSearch::inside(const Vec2& p) const {
    bool found = outline_.inside;
    for (const Segment2& s : outline_.segments) {
        found = found != crosses(outline_.reference, p, s);
    }
    return found;
}

bool VoidSearch::outside(const Fragment& fragment) const {
    return !outline_.segments.empty() && !inside((fragment[0] + fragment[1] + fragment[2]) / 3.0) &&
           std::none_of(outline_.segments.begin(), outline_.segments.end(),
                        [&](const Segment2& s) { return meets(fragment, s); });
}

bool VoidSearch::free(const Vec2& p) const {
    const double here = radius_at(p);
    return inside(p) && std::none_of(discs_.begin(), discs_.end(), [&](const Cavity& d) {
               const double radius = d.radius > 0.0 ? d.radius : here;
               return (p - d.centre).squaredNorm() + d.height < radius * radius;
           });
}

bool VoidSearch::covered(const Fragment& fragment) {
    const double least = std::min({radius_at(fragment[0]), radius_at(fragment[1]), radius_at(fragment[2])});
    covers_.clear();
    unsigned all = 0;
    for (const Cavity& d : discs_) {
        const double radius = d.radius > 0.0 ? d.radius : least;
        Cover cover{d.centre, radius * radius - d.height, 0};
        for (unsigned i = 0; i < 3; ++i) {
            cover.corners |= cover.holds(fragment[i]) ? 1U << i : 0U;
        }
        if (cover.corners == kAll) {
            return true;
        }
        if (cover.corners != 0) {
            covers_.push_back(cover);
            all |= cover.corners;
        }
    }
    return all == kAll && (covered_by_two(fragment) || covered_by_three(fragment));
}

// Returns the fraction of a side, from the first end, which the disc holds, that lies in the disc.
double VoidSearch::part_held(const Cover& cover, const Vec2& from, const Vec2& to) {
    const Vec2 along = to - from;
    const Vec2 arm = from - cover.centre;
    const double square = along.squaredNorm();
    const double half = arm.dot(along);
    return (std::sqrt(std::max(0.0, half * half - square * (arm.squaredNorm() - cover.reach))) - half) / square;
}

// Whether disc a, which holds one end of a side, and disc b, which holds the other end, cover the whole side.
bool VoidSearch::hold_side(const Cover& a, const Vec2& from, const Cover& b, const Vec2& to) {
    return part_held(a, from, to) + part_held(b, to, from) > 1.0;
}

// One disc holds a corner, another the two other corners, and both sides at the first corner have a point in both
// discs: the line through these points separates the fragment into two convex pieces, each of which lies in one disc.
bool VoidSearch::covered_by_two(const Fragment& fragment) const {
    for (const Cover& most : covers_) {
        for (int i = 0; i < 3; ++i) {
            if ((most.corners | 1U << i) != kAll) {
                continue;
            }
            for (const Cover& one : covers_) {
                if ((one.corners >> i & 1U) != 0 && hold_side(one, fragment[i], most, fragment[(i + 1) % 3]) &&
                    hold_side(one, fragment[i], most, fragment[(i + 2) % 3])) {
                    return true;
                }
            }
        }
    }
    return false;
}

// Each of three discs holds one corner and the fragment's centre, and any two of them cover the side between their
// corners: the discs then cover three convex pieces around the centre.
bool VoidSearch::covered_by_three(const Fragment& fragment) const {
    const Vec2 centre = (fragment[0] + fragment[1] + fragment[2]) / 3.0;
    const auto holds = [&](const Cover& c, unsigned i) { return (c.corners >> i & 1U) != 0 && c.holds(centre); };
    for (const Cover& a : covers_) {
        if (!holds(a, 0)) {
            continue;
        }
        for (const Cover& b : covers_) {
            if (!holds(b, 1) || !hold_side(a, fragment[0], b, fragment[1])) {
                continue;
            }
            for (const Cover& c : covers_) {
                if (holds(c, 2) && hold_side(b, fragment[1], c, fragment[2]) &&
                    hold_side(c, fragment[2], a, fragment[0])) {
                    return true;
                }
            }
        }
    }
    return false;
}

std::optional<Vec2> VoidSearch::find(double least, std::mt19937_64& random) {
    if (size_ == 0.0) {
        return std::nullopt;
    }
    // Halving bisects areas, so that all fragments of one generation have equal area.
    std::vector<Fragment> fragments{whole_};
    while (!fragments.empty()) {
        for (int i = 0; i < FrontTuning::kDarts; ++i) {
            const Vec2 p = dart(fragments[random() % fragments.size()], random);
            if (free(p)) {
                const double b = p.y() / whole_[2].y();
                return Vec2((p.x() - b * whole_[2].x()) / whole_[1].x(), b);
            }
        }
        std::vector<Fragment> next;
        for (const Fragment& fragment : fragments) {
            for (const Fragment& half : halves(fragment)) {
                if (length(half, longest_side(half)) > least && !outside(half) && !covered(half)) {
                    next.push_back(half);
                }
            }
        }
        fragments.swap(next);
    }
    return std::nullopt;
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/fan_feasibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/angle.h"
#include "triangulate/operators/tuning.h"

namespace mq::triangulate {

namespace {

// The distance of apexes from the planes of sides is estimated from the other corners: this factor is the safety
// margin.
constexpr double kEstimated = 0.95;
constexpr double kAngleMargin = 1.0 - 1e-9;  // Margin for rounding in the comparison of angles.

// Whether the angle inside the disc between the side that ends at a corner and the one that begins there is smaller
// than the one with this cosine. Far cheaper than the angle.
bool is_narrower(const Vec3& to, const Vec3& from, const Vec3& normal, double cosine) {
    return to.dot(from) > cosine * std::sqrt(to.squaredNorm() * from.squaredNorm()) && to.cross(from).dot(normal) > 0.0;
}

// Returns the least squared cosine of the angle, seen from a corner, between another corner of the boundary and the
// plane of its sides.
double squared_cosine_out_of_plane(const ClassifiedMesh& mesh, const Cavity& disc, const Vec3& corner,
                                   const Vec3& plane) {
    double largest = 0.0;
    for (const int side : disc.rim) {
        const Vec3 way = mesh.point_of(side) - corner;
        const double out = way.dot(plane);
        largest = std::max(largest, out * out / std::max(way.squaredNorm() * plane.squaredNorm(), 1e-300));
    }
    return std::max(0.0, 1.0 - largest);
}

// Returns the smallest angle between two sides that a spoke can divide into two angles of `angle`, if the spoke leaves
// their plane by an angle with this squared cosine: half of the angle, the spoke's angle, and the angle out of the
// plane are the sides of a right spherical triangle.
double least_to_part(double angle, double squared_cosine) {
    const double cosine = std::cos(angle);
    return squared_cosine > cosine * cosine ? 2.0 * std::acos(cosine / std::sqrt(squared_cosine)) : 0.0;
}

// The plane points of a convex region, counter-clockwise.
using Region = std::vector<Vec2>;

// Keeps the region on the left of a line.
void clip(Region& region, const Vec2& on_line, const Vec2& direction, Region& scratch) {
    scratch.clear();
    for (std::size_t i = 0; i < region.size(); ++i) {
        const Vec2& p = region[i];
        const Vec2& q = region[i + 1 < region.size() ? i + 1 : 0];
        const double of_p = cross(direction, p - on_line);
        const double of_q = cross(direction, q - on_line);
        if (of_p >= 0.0) {
            scratch.push_back(p);
        }
        if ((of_p < 0.0) != (of_q < 0.0)) {
            scratch.emplace_back(p + (q - p) * (of_p / (of_p - of_q)));
        }
    }
    region.swap(scratch);
}

// A boundary projected onto the plane of its disc.
struct PlaneRim {
    std::vector<std::array<Vec2, 2>> sides;
    double height = 0.0;    // largest distance of a corner from the plane through the middle
    double shortest = 0.0;  // length of the shortest side in space

    PlaneRim(const ClassifiedMesh& mesh, const Cavity& disc) {
        const Vec3 z = disc.normal.normalized();
        const Vec3 x = z.unitOrthogonal();
        const Vec3 y = z.cross(x);
        Vec3 middle = Vec3::Zero();
        for (const int side : disc.rim) {
            middle += mesh.point_of(side) / static_cast<double>(disc.rim.size());
        }
        double least = std::numeric_limits<double>::infinity();
        sides.reserve(disc.rim.size());
        for (const int side : disc.rim) {
            const Vec3 a = mesh.point_of(side) - middle;
            const Vec3 b = mesh.point_of(ClassifiedMesh::next(side)) - middle;
            sides.push_back({Vec2(a.dot(x), a.dot(y)), Vec2(b.dot(x), b.dot(y))});
            height = std::max(height, std::abs(a.dot(z)));
            least = std::min(least, (b - a).squaredNorm());
        }
        shortest = std::sqrt(least);
    }
};

// Returns the first side, by its index, that leaves those before it no apex from which all triangles have `angle` at
// their ends; -1: there may be one. In the plane each end of a side allows one half of it, and the halves must have
// points in common (Amenta, Bern and Eppstein 1999).
//
// In space an angle between directions that rise by up to s for each unit of their length may differ from the one in
// the plane by s^2 / tan(f / 2), where f is the smaller of both. In such a fan the spokes are as long as sin(angle)
// times a side, so that to an apex between the lowest and the highest corner s is below 2 height / (shortest side
// sin(angle)).
int side_without_apexes(const PlaneRim& rim, double angle) {
    constexpr double kMostLost = 0.2;  // fraction of the angle by which projection may change it
    const double slope = 2.0 * rim.height / (rim.shortest * std::sin(angle));
    const double lost = slope * slope / std::tan(0.5 * (1.0 - kMostLost) * angle);
    if (!(angle > 0.0 && lost <= kMostLost * angle)) {
        return -1;  // too far from plane to tell
    }
    const double cosine = std::cos(angle - lost);
    const double sine = std::sin(angle - lost);
    Vec2 low = rim.sides.front()[0];
    Vec2 high = low;
    for (const auto& side : rim.sides) {
        low = low.cwiseMin(side[0]);
        high = high.cwiseMax(side[0]);
    }
    Region region{low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())};
    Region scratch;
    region.reserve(region.size() + 2 * rim.sides.size());
    scratch.reserve(region.size() + 2 * rim.sides.size());
    for (std::size_t k = 0; k < rim.sides.size(); ++k) {
        const auto& [a, b] = rim.sides[k];
        const Vec2 d = b - a;
        clip(region, a, Vec2(cosine * d.x() - sine * d.y(), sine * d.x() + cosine * d.y()), scratch);
        clip(region, b, Vec2(cosine * d.x() + sine * d.y(), cosine * d.y() - sine * d.x()), scratch);
        if (region.empty()) {
            return static_cast<int>(k);
        }
    }
    return -1;
}

}  // namespace

FanFeasibility::FanFeasibility(const ClassifiedMesh& mesh, const Cavity& disc, double angle)
    : angle_(kAngleMargin * angle),
      blocking_side_(side_without_apexes(PlaneRim(mesh, disc), angle_)),
      angles_(disc.rim.size(), 2.0 * M_PI),
      next_(disc.rim.size()),
      before_(disc.rim.size()) {
    const double cosine = std::cos(2.0 * angle);
    for (std::size_t k = 0; k < disc.rim.size(); ++k) {
        const int end = mesh.site_of(ClassifiedMesh::next(disc.rim[k]));
        const auto begins = [&](int side) { return mesh.site_of(side) == end; };
        const auto next = std::find_if(disc.rim.begin(), disc.rim.end(), begins);
        next_[k] = static_cast<std::size_t>(next - disc.rim.begin());
        before_[next_[k]] = k;
        const Vec3& corner = mesh.point_of(*next);
        const Vec3 to = mesh.point_of(ClassifiedMesh::next(*next)) - corner;
        const Vec3 from = mesh.point_of(disc.rim[k]) - corner;
        if (!is_narrower(to, from, disc.normal, cosine)) {
            continue;
        }
        angles_[next_[k]] = angle_between(to, from);
        if (angles_[next_[k]] <
            kEstimated * least_to_part(angle, squared_cosine_out_of_plane(mesh, disc, corner, to.cross(from)))) {
            narrow_.push_back(next_[k]);
        }
    }
}

bool FanFeasibility::allow_inner_apex() const {
    return narrow_.empty() && blocking_side_ < 0 &&
           OperatorTuning::kSaddle * static_cast<double>(angles_.size()) * angle_ <= 2.0 * M_PI;
}

bool FanFeasibility::allow_apex(std::size_t k) const {
    const auto without_spoke = [&](std::size_t corner) {
        return corner == k || corner == next_[k] || corner == before_[k];
    };
    return angles_[next_[k]] >= angle_ && angles_[before_[k]] >= angle_ &&
           std::all_of(narrow_.begin(), narrow_.end(), without_spoke);
}

}  // namespace mq::triangulate

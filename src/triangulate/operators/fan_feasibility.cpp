// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/fan_feasibility.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "triangulate/operators/tuning.h"

namespace mq::triangulate {

namespace {

// The distance of apexes from the planes of sides is estimated from the other corners: this factor is the safety
// margin.
constexpr double kEstimated = 0.95;
constexpr double kRounding = 1.0 - 1e-9;  // Margin for rounding in the comparison of angles.

// Returns the angle between the side that ends at a corner and the one that begins there, radians.
double inner_angle(const Vec3& to, const Vec3& from, const Vec3& normal) {
    const double angle = angle_between(to, from);
    return to.cross(from).dot(normal) > 0.0 ? angle : 2.0 * M_PI - angle;
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

}  // namespace

FanFeasibility::FanFeasibility(const ClassifiedMesh& mesh, const Cavity& disc, double angle)
    : angle_(kRounding * angle), angles_(disc.rim.size()), next_(disc.rim.size()), before_(disc.rim.size()) {
    for (std::size_t k = 0; k < disc.rim.size(); ++k) {
        const int end = mesh.site_of(ClassifiedMesh::next(disc.rim[k]));
        const auto begins = [&](int side) { return mesh.site_of(side) == end; };
        const auto next = std::find_if(disc.rim.begin(), disc.rim.end(), begins);
        next_[k] = static_cast<std::size_t>(next - disc.rim.begin());
        before_[next_[k]] = k;
        const Vec3& corner = mesh.point_of(*next);
        const Vec3 to = mesh.point_of(ClassifiedMesh::next(*next)) - corner;
        const Vec3 from = mesh.point_of(disc.rim[k]) - corner;
        angles_[next_[k]] = inner_angle(to, from, disc.normal);
        if (angles_[next_[k]] < 2.0 * angle &&
            angles_[next_[k]] <
                kEstimated * least_to_part(angle, squared_cosine_out_of_plane(mesh, disc, corner, to.cross(from)))) {
            narrow_.push_back(next_[k]);
        }
    }
}

bool FanFeasibility::allow_inner_apex() const {
    return narrow_.empty() && OperatorTuning::kSaddle * static_cast<double>(angles_.size()) * angle_ <= 2.0 * M_PI;
}

bool FanFeasibility::allow_apex(std::size_t k) const {
    const auto without_spoke = [&](std::size_t corner) {
        return corner == k || corner == next_[k] || corner == before_[k];
    };
    return angles_[next_[k]] >= angle_ && angles_[before_[k]] >= angle_ &&
           std::all_of(narrow_.begin(), narrow_.end(), without_spoke);
}

}  // namespace mq::triangulate

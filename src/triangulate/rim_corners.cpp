// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/rim_corners.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

// A spoke leaves the plane of the two sides where the surface is bent: the angles beside it are together more than the
// one between the sides then, of which this part is counted on.
constexpr double kBent = 0.8;

// Radians, between the side that ends there and the one that begins.
double inner_angle(const SurfaceMesh& mesh, int ends, int begins, const Vec3& normal) {
    const Vec3& corner = mesh.point_of(begins);
    const Vec3 to = mesh.point_of(SurfaceMesh::next(begins)) - corner;
    const Vec3 from = mesh.point_of(ends) - corner;
    const double angle = angle_between(to, from);
    return to.cross(from).dot(normal) > 0.0 ? angle : 2.0 * M_PI - angle;
}

}  // namespace

RimCorners::RimCorners(const SurfaceMesh& mesh, const Disc& disc, double angle)
    : least_(kBent * angle), angles_(disc.rim.size()), next_(disc.rim.size()), before_(disc.rim.size()) {
    for (std::size_t k = 0; k < disc.rim.size(); ++k) {
        const int end = mesh.site_of(SurfaceMesh::next(disc.rim[k]));
        const auto begins = [&](int side) { return mesh.site_of(side) == end; };
        next_[k] = static_cast<std::size_t>(std::find_if(disc.rim.begin(), disc.rim.end(), begins) - disc.rim.begin());
        before_[next_[k]] = k;
        angles_[next_[k]] = inner_angle(mesh, disc.rim[k], disc.rim[next_[k]], disc.normal);
    }
    for (std::size_t k = 0; k < angles_.size(); ++k) {
        if (angles_[k] < 2.0 * least_) {
            narrow_.push_back(k);
        }
    }
}

bool RimCorners::allow_inner_apex() const {
    return narrow_.empty() && static_cast<double>(angles_.size()) * least_ <= 2.0 * M_PI;
}

bool RimCorners::allow_apex(std::size_t k) const {
    const auto without_spoke = [&](std::size_t corner) {
        return corner == k || corner == next_[k] || corner == before_[k];
    };
    return angles_[k] >= static_cast<double>(angles_.size() - 2) * least_ && angles_[next_[k]] >= least_ &&
           angles_[before_[k]] >= least_ && std::all_of(narrow_.begin(), narrow_.end(), without_spoke);
}

}  // namespace mq::triangulate

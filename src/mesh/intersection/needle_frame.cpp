// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/needle_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace mq::mesh {

namespace {

/// Number of triangles that are examined.
constexpr std::size_t kSamples = 512;
/// Ratio of length to height above which a triangle is a needle.
constexpr double kNeedle = 20.0;
/// Fraction of needles among the samples above which a frame is worth its cost.
constexpr double kWorthAFrame = 0.1;
/// Least cosine between two directions that count as equal: 5 degrees.
constexpr double kSameDirection = 0.996;
/// Largest cosine between directions that count as perpendicular: 17 degrees.
constexpr double kPerpendicular = 0.3;

/// The long edges of the needles among a sample of the triangles.
std::vector<Vec3> needles(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
    std::vector<Vec3> result;
    const std::size_t stride = std::max<std::size_t>(1, triangles.size() / kSamples);
    for (std::size_t t = 0; t < triangles.size(); t += stride) {
        const Triangle& c = triangles[t];
        Vec3 longest = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 edge =
                vertices[static_cast<std::size_t>(c[(k + 1) % 3])] - vertices[static_cast<std::size_t>(c[k])];
            longest = edge.squaredNorm() > longest.squaredNorm() ? edge : longest;
        }
        const Vec3& a = vertices[static_cast<std::size_t>(c[0])];
        const double two_areas =
            (vertices[static_cast<std::size_t>(c[1])] - a).cross(vertices[static_cast<std::size_t>(c[2])] - a).norm();
        if (longest.squaredNorm() > kNeedle * two_areas) {
            result.push_back(longest);
        }
    }
    return result;
}

/// The direction with most of the needles' length within 5 degrees; zero when there is none.
Vec3 main_direction(const std::vector<Vec3>& needles) {
    Vec3 best = Vec3::Zero();
    double most = 0.0;
    for (const Vec3& candidate : needles) {
        const Vec3 way = candidate.normalized();
        Vec3 sum = Vec3::Zero();
        double length = 0.0;
        for (const Vec3& needle : needles) {
            const double along = needle.dot(way);
            if (std::abs(along) > kSameDirection * needle.norm()) {
                sum += along > 0.0 ? needle : Vec3(-needle);
                length += std::abs(along);
            }
        }
        if (length > most) {
            most = length;
            best = sum.normalized();
        }
    }
    return best;
}

}  // namespace

NeedleFrame::NeedleFrame(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles)
    : vertices_(vertices) {
    std::vector<Vec3> long_edges = needles(vertices, triangles);
    if (static_cast<double>(long_edges.size()) <
        kWorthAFrame * static_cast<double>(std::min(kSamples, triangles.size()))) {
        return;
    }
    const Vec3 first = main_direction(long_edges);
    if (first.isZero()) {
        return;
    }
    long_edges.erase(
        std::remove_if(long_edges.begin(), long_edges.end(),
                       [&](const Vec3& edge) { return std::abs(edge.dot(first)) > kPerpendicular * edge.norm(); }),
        long_edges.end());
    for (Vec3& edge : long_edges) {
        edge -= edge.dot(first) * first;
    }
    Vec3 second = main_direction(long_edges);
    if (second.isZero()) {
        second = first.unitOrthogonal();
    }
    second = (second - second.dot(first) * first).normalized();
    frame_ << first.transpose(), second.transpose(), first.cross(second).transpose();
    double farthest = 0.0;
    turned_.reserve(vertices.size());
    for (const Vec3& p : vertices) {
        turned_.emplace_back(frame_ * p);
        farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    }
    // Three products and two sums, each with an error of half a unit in the last place, and as much again for a frame
    // whose rows are not quite perpendicular.
    slack_ = 16.0 * std::numeric_limits<double>::epsilon() * farthest;
}

void NeedleFrame::add(const Vec3& vertex) {
    if (slack_ > 0.0) {
        turned_.push_back(turned(vertex));
    }
}

}  // namespace mq::mesh

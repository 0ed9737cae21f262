// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/thickness.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "base/error.h"
#include "base/parallel.h"
#include "inspection/largest_ball.h"
#include "inspection/ray_crossings.h"
#include "inspection/surface_normals.h"
#include "mesh/intersection/nearest_tree.h"
#include "option_ranges.h"

namespace mq::inspection {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Sample points along the largest side of the model's box, if no spacing is given.
constexpr double kPointsAcross = 50.0;
/// Rows of sample points in one triangle at most.
constexpr int kMostRows = 32;
/// Triangles that a thread takes at a time.
constexpr std::size_t kChunk = 256;

struct Measured {
    double value = kInfinite;
    Vec3 point = Vec3::Zero();
    std::int32_t opposite = -1;
    bool is_wall = false;
};

/// Replaces `least` by a sample that is the first one of its triangle or ranks before it: samples on walls rank first,
/// then smaller values, then
/// numbers.
void keep_least(const Measured& sample, bool first, Measured& least) {
    const bool better = sample.is_wall != least.is_wall ? sample.is_wall : sample.value < least.value;
    if (first || better || (std::isnan(least.value) && !std::isnan(sample.value))) {
        least = sample;
    }
}

class Gauge {
  public:
    Gauge(const mesh::TriangleMesh& mesh, const std::vector<std::int32_t>& body, const ThicknessOptions& options,
          const Progress* progress)
        : mesh_(mesh),
          body_(body),
          normals_(mesh, progress),
          outside_(options.outside),
          corner_angle_(options.corner_angle * M_PI / 180.0) {
        std::vector<std::vector<std::int32_t>> members(1);
        for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
            const auto b = static_cast<std::size_t>(body.empty() ? 0 : body[k]);
            members.resize(std::max(members.size(), b + 1));
            members[b].push_back(static_cast<std::int32_t>(k));
        }
        Box all;
        for (const std::vector<std::int32_t>& triangles : members) {
            check_cancelled(progress);
            trees_.push_back(std::make_unique<mesh::NearestTree>(mesh.vertices, mesh.triangles, triangles));
            all.add(trees_.back()->box());
        }
        spacing_ = options.spacing > 0.0 ? options.spacing : all.largest_side() / kPointsAcross;
    }

    /// @param known  free balls of the body that the triangle belongs to
    void measure(std::int32_t triangle, Measured& by_ray, Measured& by_ball, FreeBalls& known) const {
        const mesh::Triangle& t = mesh_.triangles[triangle];
        const Vec3 &a = mesh_.vertices[t[0]], &b = mesh_.vertices[t[1]], &c = mesh_.vertices[t[2]];
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        const int rows = spacing_ > 0.0 ? std::clamp(static_cast<int>(std::ceil(longest / spacing_)), 1, kMostRows) : 1;
        // The centroids of the rows^2 triangles into which the triangle is divided.
        bool first = true;
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; i + j < rows; ++j) {
                for (const double third : {1.0, 2.0}) {
                    if (third == 1.0 || i + j + 1 < rows) {
                        Vec3 weights(0.0, (i + third / 3.0) / rows, (j + third / 3.0) / rows);
                        weights[0] = 1.0 - weights[1] - weights[2];
                        Measured ray;
                        Measured ball;
                        measure_at(triangle, weights, weights[0] * a + weights[1] * b + weights[2] * c, known, ray,
                                   ball);
                        keep_least(ray, first, by_ray);
                        keep_least(ball, first, by_ball);
                        first = false;
                    }
                }
            }
        }
    }

  private:
    void measure_at(std::int32_t triangle, const Vec3& weights, const Vec3& point, FreeBalls& known, Measured& by_ray,
                    Measured& by_ball) const {
        by_ray.point = by_ball.point = point;
        const Vec3 normal = normals_.at(triangle, weights);
        if (!(normal.squaredNorm() > 0.0)) {
            by_ray.value = by_ball.value = std::numeric_limits<double>::quiet_NaN();
            return;
        }
        const Vec3 direction = outside_ ? normal : Vec3(-normal);
        const mesh::NearestTree& tree = *trees_[static_cast<std::size_t>(body_.empty() ? 0 : body_[triangle])];
        const std::vector<Crossing> crossings =
            crossings_of(tree, mesh_.vertices, mesh_.triangles, point, direction, triangle);
        int winding = winding_at_start(crossings);
        if (winding != (outside_ ? 0 : 1)) {
            by_ray.value = by_ball.value = std::numeric_limits<double>::quiet_NaN();
            return;
        }
        for (const Crossing& crossing : crossings) {
            winding += crossing.leaves ? -1 : 1;
            if (outside_ ? winding > 0 : winding <= 0) {
                by_ray.value = crossing.distance;
                by_ray.opposite = crossing.triangle;
                const Vec3& exit = normals_.of_plane(crossing.triangle);
                by_ray.is_wall = std::abs(exit.dot(direction)) >= std::cos(corner_angle_);
                break;
            }
        }
        const double allowance = normals_.allowance(triangle);
        const LargestBall ball = largest_ball(tree, point, direction, allowance, by_ray.value, by_ray.opposite, known);
        if (ball.triangle >= 0) {
            const OppositeContact contact =
                opposite_contact(tree, mesh_.vertices, mesh_.triangles, ball, direction, corner_angle_);
            by_ball.is_wall = contact.triangle >= 0;
            by_ball.opposite = by_ball.is_wall ? contact.triangle : ball.triangle;
            by_ball.value = ball.radius + (by_ball.is_wall ? contact.distance : ball.radius);
        }
    }

    const mesh::TriangleMesh& mesh_;
    const std::vector<std::int32_t>& body_;
    SurfaceNormals normals_;
    std::vector<std::unique_ptr<mesh::NearestTree>> trees_;
    bool outside_;
    double corner_angle_;
    double spacing_ = 0.0;
};

ThicknessValues values_of(const std::vector<Measured>& measured) {
    ThicknessValues values;
    for (const Measured& one : measured) {
        values.value.push_back(one.value);
        values.point.push_back(one.point);
        values.opposite.push_back(one.opposite);
        values.is_wall.push_back(static_cast<char>(one.is_wall));
    }
    return values;
}

}  // namespace

void ThicknessOptions::validate() const {
    ranges::inspection::kSpacing.require(spacing);
    ranges::inspection::kCornerAngle.require(corner_angle);
}

Thickness thickness(const mesh::TriangleMesh& mesh, const std::vector<std::int32_t>& body,
                    const ThicknessOptions& options, Progress* progress) {
    options.validate();
    const Gauge gauge(mesh, body, options, progress);
    const std::size_t count = mesh.triangles.size();
    std::vector<Measured> rays(count);
    std::vector<Measured> balls(count);
    const std::size_t chunks = (count + kChunk - 1) / kChunk;
    std::atomic<std::size_t> done{0};
    parallel_for(static_cast<int>(chunks), [&](int chunk) {
        const std::size_t begin = kChunk * static_cast<std::size_t>(chunk);
        FreeBalls known;
        std::int32_t last = 0;
        for (std::size_t k = begin; k < std::min(begin + kChunk, count); ++k) {
            check_cancelled(progress);
            const std::int32_t present = body.empty() ? 0 : body[k];
            known = present == last ? known : FreeBalls();
            last = present;
            gauge.measure(static_cast<std::int32_t>(k), rays[k], balls[k], known);
        }
        if (progress != nullptr) {
            progress->advance(static_cast<double>(++done) / static_cast<double>(chunks));
        }
    });
    return {values_of(rays), values_of(balls)};
}

}  // namespace mq::inspection

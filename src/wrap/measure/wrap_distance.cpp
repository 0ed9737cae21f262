// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/measure/wrap_distance.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>

#include "base/parallel.h"
#include "inspection/ray_crossings.h"

namespace mq::wrap {

namespace {

struct Farthest {
    double distance = 0.0;
    Vec3 where = Vec3::Zero();
};

/// Calls visit(point) for points of a triangle that are at most `spacing` apart along its sides.
template <typename Visit>
void for_each_sample(const std::array<Vec3, 3>& c, double spacing, const Visit& visit) {
    const double longest = std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
    const int parts = std::max(2, static_cast<int>(std::ceil(longest / spacing)));
    for (int i = 0; i <= parts; ++i) {
        for (int j = 0; i + j <= parts; ++j) {
            visit(Vec3(c[0] + (c[1] - c[0]) * (double(i) / parts) + (c[2] - c[0]) * (double(j) / parts)));
        }
    }
}

/// The farthest of all samples of some triangles: measure(point, bound) returns the distance of a sample if it is above
/// the bound, else 0. Advances the stage by half.
template <typename Counts, typename Measure>
Farthest farthest_of(const std::vector<Vec3>& points, const std::vector<mesh::Triangle>& triangles, double spacing,
                     const Counts& counts, const Measure& measure, Progress& progress, double from) {
    constexpr std::size_t kBlock = 256;
    std::vector<Farthest> blocks((triangles.size() + kBlock - 1) / kBlock);
    std::atomic<int> done{0};
    parallel_for(static_cast<int>(blocks.size()), [&](int k) {
        progress.check();
        progress.advance(from + 0.5 * done++ / static_cast<double>(blocks.size()));
        Farthest& found = blocks[static_cast<std::size_t>(k)];
        const std::size_t first = static_cast<std::size_t>(k) * kBlock;
        for (std::size_t t = first; t < std::min(first + kBlock, triangles.size()); ++t) {
            const mesh::Triangle& c = triangles[t];
            if (!counts(t)) {
                continue;
            }
            for_each_sample({points[c[0]], points[c[1]], points[c[2]]}, spacing, [&](const Vec3& p) {
                const double distance = measure(p, found.distance);
                found = distance > found.distance ? Farthest{distance, p} : found;
            });
        }
    });
    Farthest result;
    for (const Farthest& block : blocks) {
        result = block.distance > result.distance ? block : result;
    }
    return result;
}

}  // namespace

WrapDistance wrap_distance(const mesh::TriangleMesh& wrap, const std::vector<std::int32_t>& source,
                           const InputSurface& input, double spacing, Progress& progress) {
    const Farthest to_input = farthest_of(
        wrap.vertices, wrap.triangles, spacing, [&](std::size_t t) { return source[t] >= 0; },
        [&](const Vec3& p, double) { return input.tree.nearest(p).distance; }, progress, 0.0);
    const mesh::NearestTree tree(wrap.vertices, wrap.triangles);
    // The direction is arbitrary: which triangles the ray crosses is decided exactly.
    const Vec3 direction = Vec3(0.48, 0.6, 0.64);
    const Farthest from_input = farthest_of(
        input.points, input.triangles, spacing, [](std::size_t) { return true; },
        [&](const Vec3& p, double bound) {
            const double distance = tree.nearest(p).distance;
            if (distance <= bound) {
                return 0.0;
            }
            const bool inside = inspection::winding_at_start(inspection::crossings_of(
                                    tree, wrap.vertices, wrap.triangles, p, direction, -1)) > 0;
            return inside ? 0.0 : distance;
        },
        progress, 0.5);
    return {to_input.distance, to_input.where, from_input.distance, from_input.where};
}

}  // namespace mq::wrap

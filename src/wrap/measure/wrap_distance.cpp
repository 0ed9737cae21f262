// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/measure/wrap_distance.h"

#include <cstddef>

#include "inspection/ray_crossings.h"

namespace mq::wrap {

namespace {

/// The triangles that are not left out.
template <typename Counts>
std::vector<mesh::Corners> corners_of(const std::vector<Vec3>& points, const std::vector<mesh::Triangle>& triangles,
                                      const Counts& counts) {
    std::vector<mesh::Corners> found;
    found.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (counts(t)) {
            const mesh::Triangle& c = triangles[t];
            found.push_back({points[c[0]], points[c[1]], points[c[2]]});
        }
    }
    return found;
}

}  // namespace

WrapDistance wrap_distance(const mesh::TriangleMesh& wrap, const std::vector<std::int32_t>& source,
                           const InputSurface& input, double spacing, Progress& progress) {
    constexpr double kFineness = 0.02;  // distances are proven to this fraction of a spacing
    const double fineness = kFineness * spacing;
    const mesh::ProvenBound to_input = mesh::deviation_from_distance(
        corners_of(wrap.vertices, wrap.triangles, [&](std::size_t t) { return source[t] >= 0; }), input, 0.0, fineness,
        progress);
    progress.advance(0.25);
    const mesh::SearchedSurface surface(wrap.vertices, wrap.triangles);
    // The direction is arbitrary: which triangles the ray crosses is decided exactly.
    const Vec3 direction(0.48, 0.6, 0.64);
    const mesh::ProvenBound from_input = mesh::distance_of_points_outside(
        corners_of(input.points, input.triangles, [](std::size_t) { return true; }), surface,
        [&](const Vec3& p) {
            return inspection::winding_at_start(
                       inspection::crossings_of(surface.tree, wrap.vertices, wrap.triangles, p, direction, -1)) > 0;
        },
        fineness, progress, 0.25);
    return {to_input.bound, to_input.where, from_input.bound, from_input.where};
}

}  // namespace mq::wrap

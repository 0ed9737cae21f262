// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/surface_flips.h"

#include <algorithm>
#include <numeric>

#include "base/predicates.h"

namespace mq::triangulate {

using VertexUse = FaceMesh::VertexUse;

// Terminates since both measures of better_flipped only ever increase.
void SurfaceFlips::run() {
    std::vector<int> open(static_cast<std::size_t>(3 * plane.triangle_count()));
    std::iota(open.begin(), open.end(), 0);
    while (!open.empty()) {
        const int h = open.back();
        open.pop_back();
        const int g = plane.twin(h);
        if (g >= 0 && inside[h / 3] == 1 && inside[g / 3] == 1 && better_flipped(h) && plane.flip_edge(h)) {
            for (const int t : {h / 3, g / 3}) {
                open.insert(open.end(), {3 * t, 3 * t + 1, 3 * t + 2});
            }
        }
    }
}

bool SurfaceFlips::better_flipped(int h) const {
    constexpr double kCosineRounding = 1e-9;  // Rounding of a cosine: a smaller gain could be undone by the next flip.
    const int g = plane.twin(h);
    const int a = plane.corner(h);
    const int b = plane.corner(ConstrainedDelaunay::next(h));
    const int c = plane.corner(ConstrainedDelaunay::prev(h));
    const int d = plane.corner(ConstrainedDelaunay::prev(g));
    if (site(c).vertex >= 0 && site(c).vertex == site(d).vertex) {
        return false;
    }
    const double now = std::min(uprightness(a, b, c), uprightness(b, a, d));
    const double then = std::min(uprightness(a, d, c), uprightness(d, b, c));
    return then > now + kCosineRounding ||
           (for_angles && now == upright && then == upright &&
            !locally_maxmin(site(a).point, site(b).point, site(c).point, site(d).point));
}

// Returns the least cosine between the normal of a triangle and those of the surface at its corners, limited to
// `upright`.
double SurfaceFlips::uprightness(int a, int b, int c) const {
    const Vec3 normal = (site(b).point - site(a).point).cross(site(c).point - site(a).point);
    const bool flat = !(normal.squaredNorm() > 0.0);
    double least = upright;
    for (const int corner : {a, b, c}) {
        const Vec3& outward = site(corner).normal;
        if (outward.squaredNorm() > 0.0) {
            least = std::min(least, flat ? -1.0 : (reversed ? -1.0 : 1.0) * normal.normalized().dot(outward));
        }
    }
    return least;
}

}  // namespace mq::triangulate

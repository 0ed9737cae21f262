// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/deviation.h"

#include <cmath>

namespace mq::triangulate {

using mesh::SurfaceMesh;

namespace {

// With the surface's slopes at the ends.
struct Cubic {
    double length = 0.0;
    double slope = 0.0;
    double last_slope = 0.0;

    double at(double x) const { return length * x * (1.0 - x) * (slope * (1.0 - x) - last_slope * x); }
};

Cubic cubic_between(const SurfaceMesh::Site& from, const SurfaceMesh::Site& to) {
    const Vec3 along = to.point - from.point;
    const Vec3 up = (from.normal + to.normal).normalized();
    const double length = along.norm();
    const double slope = -from.normal.dot(along) / (length * from.normal.dot(up));
    const double last_slope = -to.normal.dot(along) / (length * to.normal.dot(up));
    if (!std::isfinite(slope) || !std::isfinite(last_slope)) {
        return {};  // no normal at an end
    }
    return {length, slope, last_slope};
}

}  // namespace

EdgePeak edge_peak(const SurfaceMesh& mesh, int half_edge) {
    const auto& from = mesh.site(mesh.site_of(half_edge));
    const auto& to = mesh.site(mesh.site_of(SurfaceMesh::next(half_edge)));
    return edge_peak(from, to);
}

EdgePeak edge_peak(const SurfaceMesh::Site& from, const SurfaceMesh::Site& to) {
    const Cubic cubic = cubic_between(from, to);
    EdgePeak peak;
    for (int i = 2; i <= 8; ++i) {
        const double x = 0.1 * i;
        const double height = std::abs(cubic.at(x));
        if (height > peak.height) {
            peak = {x, height};
        }
    }
    return peak;
}

TrianglePeak triangle_peak(double ab, double bc, double ca) {
    const bool same_side = (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
    const double a = bc * (ab + ca - bc);
    const double b = ca * (ab + bc - ca);
    const double c = ab * (bc + ca - ab);
    if (!same_side || !(a > 0.0) || !(b > 0.0) || !(c > 0.0)) {
        return {};
    }
    const double sum = a + b + c;
    const std::array<double, 3> w{a / sum, b / sum, c / sum};
    return {w, 4.0 * std::abs(w[0] * w[1] * ab + w[1] * w[2] * bc + w[2] * w[0] * ca)};
}

TrianglePeak expected_peak(const SurfaceMesh::Site& a, const SurfaceMesh::Site& b, const SurfaceMesh::Site& c) {
    const TrianglePeak peak =
        triangle_peak(cubic_between(a, b).at(0.5), cubic_between(b, c).at(0.5), cubic_between(c, a).at(0.5));
    constexpr double kThird = 1.0 / 3.0;
    return peak.height > 0.0 ? peak : TrianglePeak{{kThird, kThird, kThird}, 0.0};
}

}  // namespace mq::triangulate

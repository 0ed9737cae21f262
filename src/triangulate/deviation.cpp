// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/deviation.h"

#include <cmath>

namespace mq::triangulate {

using mesh::SurfaceMesh;

EdgePeak edge_peak(const SurfaceMesh& mesh, int half_edge) {
    const int next = SurfaceMesh::next(half_edge);
    const Vec3 along = mesh.point_of(next) - mesh.point_of(half_edge);
    const double length = along.norm();
    const Vec3& first = mesh.site(mesh.site_of(half_edge)).normal;
    const Vec3& last = mesh.site(mesh.site_of(next)).normal;
    const Vec3 up = (first + last).normalized();
    const double slope = -first.dot(along) / (length * first.dot(up));
    const double last_slope = -last.dot(along) / (length * last.dot(up));
    EdgePeak peak;
    if (!std::isfinite(slope) || !std::isfinite(last_slope)) {
        return peak;  // no normal at an end
    }
    for (int i = 2; i <= 8; ++i) {
        const double x = 0.1 * i;
        const double height = std::abs(length * x * (1.0 - x) * (slope * (1.0 - x) - last_slope * x));
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

}  // namespace mq::triangulate

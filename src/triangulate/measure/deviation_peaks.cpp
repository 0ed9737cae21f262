// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/deviation_peaks.h"

#include <algorithm>
#include <cmath>

#include "triangulate/measure/tuning.h"

namespace mq::triangulate {

namespace {

// The height of a surface over an edge, as a cubic with the surface's slopes at the ends, mm.
struct Cubic {
    double length = 0.0;
    double slope = 0.0;
    double last_slope = 0.0;

    double at(double x) const { return length * x * (1.0 - x) * (slope * (1.0 - x) - last_slope * x); }
};

Cubic cubic_between(const ClassifiedMesh::VertexUse& from, const ClassifiedMesh::VertexUse& to) {
    const Vec3 along = to.point - from.point;
    const Vec3 up = (from.normal + to.normal).normalized();
    const double length = along.norm();
    const double slope = -from.normal.dot(along) / (length * from.normal.dot(up));
    const double last_slope = -to.normal.dot(along) / (length * to.normal.dot(up));
    if (!std::isfinite(slope) || !std::isfinite(last_slope)) {
        return {};  // there is no normal at an end
    }
    return {length, slope, last_slope};
}

const double kPart = 1.0 / MeasureTuning::kLattice;  // Step of the lattice, as a barycentric weight.

TrianglePeak highest_of_lattice(const TriangleHeights& heights) {
    constexpr double kThird = 1.0 / 3.0;  // Barycentric weight of the centroid.
    TrianglePeak peak{{kThird, kThird, kThird}, 0.0};
    for (int i = 1; i < MeasureTuning::kLattice - 1; ++i) {
        for (int j = 1; i + j < MeasureTuning::kLattice; ++j) {
            const std::array<double, 3> weights{kPart * i, kPart * j, 1.0 - kPart * (i + j)};
            const double height = std::abs(heights.at(weights));
            if (height > peak.height) {
                peak = {weights, height};
            }
        }
    }
    return peak;
}

// Returns the maximum of the quadratic through the neighbouring lattice places, if it is at least one step inside the
// triangle; otherwise the given place.
std::array<double, 3> climbed(const TriangleHeights& heights, const std::array<double, 3>& weights) {
    const auto moved = [&](int to, int from, double way) {
        std::array<double, 3> w = weights;
        w[to] += way;
        w[from] -= way;
        return heights.at(w);
    };
    const double here = heights.at(weights);
    const auto bend = [&](int to, int from) { return moved(to, from, kPart) + moved(to, from, -kPart) - 2.0 * here; };
    const double a = bend(0, 2);
    const double c = bend(1, 2);
    const double b = 0.5 * (a + c - bend(0, 1));
    const double determinant = a * c - b * b;
    if (!(determinant > 0.0) || a * here > 0.0) {
        return weights;  // the quadratic has no maximum
    }
    const double u = 0.5 * (moved(0, 2, kPart) - moved(0, 2, -kPart));
    const double v = 0.5 * (moved(1, 2, kPart) - moved(1, 2, -kPart));
    const double x = (b * v - c * u) / determinant;
    const double y = (b * u - a * v) / determinant;
    const std::array<double, 3> top{weights[0] + kPart * x, weights[1] + kPart * y, weights[2] - kPart * (x + y)};
    return *std::min_element(top.begin(), top.end()) < kPart ? weights : top;
}

}  // namespace

EdgePeak edge_peak(const ClassifiedMesh& mesh, int half_edge) {
    const auto& from = mesh.site(mesh.site_of(half_edge));
    const auto& to = mesh.site(mesh.site_of(ClassifiedMesh::next(half_edge)));
    return edge_peak(from, to);
}

EdgePeak edge_peak(const ClassifiedMesh::VertexUse& from, const ClassifiedMesh::VertexUse& to) {
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

double side_skew(const ClassifiedMesh::VertexUse& from, const ClassifiedMesh::VertexUse& to) {
    const Cubic cubic = cubic_between(from, to);
    return 0.5 * cubic.length * (cubic.slope + cubic.last_slope);
}

double TriangleHeights::at(const std::array<double, 3>& weights) const {
    double height = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double a = weights[k];
        const double b = weights[(k + 1) % 3];
        height += a * b * (4.0 * middles[k] + skews[k] * (a - b));
    }
    return height;
}

double TriangleHeights::bound() const {
    constexpr double kOfMiddle = 4.0 / 3.0;  // ab + bc + ca is at most a third
    constexpr double kOfSkew = 0.0963;       // x (1 - x) (1 - 2 x) is at most sqrt(3) / 18
    const auto largest = [](const std::array<double, 3>& of) {
        return std::max({std::abs(of[0]), std::abs(of[1]), std::abs(of[2])});
    };
    return kOfMiddle * largest(middles) + 3.0 * kOfSkew * largest(skews);
}

TrianglePeak triangle_peak(const TriangleHeights& heights) {
    TrianglePeak peak = highest_of_lattice(heights);
    const std::array<double, 3> weights = climbed(heights, peak.weights);
    const double height = std::abs(heights.at(weights));
    return height > peak.height ? TrianglePeak{weights, height} : peak;
}

TrianglePeak expected_peak(const ClassifiedMesh::VertexUse& a, const ClassifiedMesh::VertexUse& b,
                           const ClassifiedMesh::VertexUse& c) {
    return triangle_peak({{cubic_between(a, b).at(0.5), cubic_between(b, c).at(0.5), cubic_between(c, a).at(0.5)},
                          {side_skew(a, b), side_skew(b, c), side_skew(c, a)}});
}

}  // namespace mq::triangulate

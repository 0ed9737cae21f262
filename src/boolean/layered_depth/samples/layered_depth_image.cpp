// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/layered_depth/samples/layered_depth_image.h"

#include <cmath>

namespace mq::boolean {

namespace {

/// Free cells around the box. The fractions keep rays away from faces that lie at round numbers, where the symbolic
/// perturbation would have to decide.
const Vec3 kMargin(1.4370, 1.3913, 1.5231);
/// Cells of the margin on both sides of an axis together, rounded up.
constexpr double kMarginSum = 3.2;

int levels_of(int resolution) {
    int levels = 3;
    while ((1 << levels) + 1 < resolution) {
        ++levels;
    }
    return levels;
}

}  // namespace

double SampleGrid::spacing_of(double side, int resolution) {
    return side / ((1 << levels_of(resolution)) - kMarginSum);
}

double SampleGrid::resolution_for(double side, double spacing) {
    return std::ceil(side / spacing + kMarginSum) + 1.0;
}

SampleGrid::SampleGrid(const Box& box, int resolution) {
    levels_ = levels_of(resolution);
    cells_ = 1 << levels_;
    const double side = box.empty() ? 0.0 : box.largest_side();
    spacing_ = side > 0.0 ? spacing_of(side, resolution) : 1.0;
    const Vec3 low = box.empty() ? Vec3(0.0, 0.0, 0.0) : box.low;
    origin_ = low - spacing_ * kMargin;
}

OperandPair::OperandPair(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) {
    points.reserve(a.vertices.size() + b.vertices.size());
    points.insert(points.end(), a.vertices.begin(), a.vertices.end());
    points.insert(points.end(), b.vertices.begin(), b.vertices.end());
    const auto shift = static_cast<std::int32_t>(a.vertices.size());
    triangles.reserve(a.triangles.size() + b.triangles.size());
    triangles.insert(triangles.end(), a.triangles.begin(), a.triangles.end());
    for (const mesh::Triangle& t : b.triangles) {
        triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    }
    first_triangle = {0, static_cast<std::int32_t>(a.triangles.size()), static_cast<std::int32_t>(triangles.size())};
    first_point = {0, shift, static_cast<std::int32_t>(points.size())};
}

Vec3 OperandPair::unit_normal(std::int32_t triangle) const {
    const auto& [a, b, c] = triangles[static_cast<std::size_t>(triangle)];
    const Vec3 n = (points[b] - points[a]).cross(points[c] - points[a]);
    const double length = n.norm();
    return length > 0.0 ? Vec3(n / length) : n;
}

}  // namespace mq::boolean

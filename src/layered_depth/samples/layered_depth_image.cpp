// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/layered_depth_image.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace mq::layered_depth {

namespace {

/// Free cells around the box. The fractions keep rays away from faces at round coordinates, at which the symbolic
/// perturbation would have to decide.
const Vec3 kMargin(1.4370, 1.3913, 1.5231);
/// Sum of the free cells on both sides of an axis, rounded up.
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

OperandSet::OperandSet(const std::vector<const mesh::TriangleMesh*>& operands,
                       const std::vector<std::vector<mesh::Triangle>>& borders) {
    const auto add = [this](const std::vector<mesh::Triangle>& added) {
        const std::int32_t shift = first_point.back();
        for (const mesh::Triangle& t : added) {
            triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
        }
    };
    std::size_t point_count = 0, triangle_count = 0;
    for (const mesh::TriangleMesh* operand : operands) {
        point_count += operand->vertices.size();
        triangle_count += operand->triangles.size();
    }
    points.reserve(point_count);
    triangles.reserve(triangle_count);
    for (std::size_t k = 0; k < operands.size(); ++k) {
        first_point.push_back(static_cast<std::int32_t>(points.size()));
        first_triangle.push_back(static_cast<std::int32_t>(triangles.size()));
        points.insert(points.end(), operands[k]->vertices.begin(), operands[k]->vertices.end());
        add(operands[k]->triangles);
        first_gap.push_back(static_cast<std::int32_t>(triangles.size()));
        if (!borders.empty()) {
            add(borders[k]);
        }
    }
    first_point.push_back(static_cast<std::int32_t>(points.size()));
    first_triangle.push_back(static_cast<std::int32_t>(triangles.size()));
}

LayeredDepthImage joined(std::vector<LayeredDepthImage>& bands) {
    std::vector<std::size_t> first_ray{0}, first_sample{0};
    for (const LayeredDepthImage& band : bands) {
        first_ray.push_back(first_ray.back() + band.begin.size() - 1);
        first_sample.push_back(first_sample.back() + band.depth.size());
    }
    LayeredDepthImage result;
    result.begin.resize(first_ray.back() + 1);
    result.begin.back() = static_cast<std::uint32_t>(first_sample.back());
    result.depth.resize(first_sample.back());
    result.code.resize(first_sample.back());
    const bool with_normals =
        std::any_of(bands.begin(), bands.end(), [](const LayeredDepthImage& band) { return !band.normal.empty(); });
    result.normal.resize(with_normals ? first_sample.back() : 0);
    parallel_for(static_cast<int>(bands.size()), [&](int k) {
        LayeredDepthImage& band = bands[static_cast<std::size_t>(k)];
        const auto at = static_cast<std::ptrdiff_t>(first_sample[static_cast<std::size_t>(k)]);
        std::transform(band.begin.begin(), band.begin.end() - 1,
                       result.begin.begin() + static_cast<std::ptrdiff_t>(first_ray[static_cast<std::size_t>(k)]),
                       [at](std::uint32_t i) { return i + static_cast<std::uint32_t>(at); });
        std::copy(band.depth.begin(), band.depth.end(), result.depth.begin() + at);
        std::copy(band.code.begin(), band.code.end(), result.code.begin() + at);
        std::copy(band.normal.begin(), band.normal.end(), result.normal.begin() + (with_normals ? at : 0));
        band = {};
    });
    return result;
}

int OperandSet::operand_of(std::int32_t triangle) const {
    const auto next = std::upper_bound(first_triangle.begin(), first_triangle.end() - 1, triangle);
    return static_cast<int>(next - first_triangle.begin()) - 1;
}

Vec3 OperandSet::unit_normal(std::int32_t triangle) const {
    const auto& [a, b, c] = triangles[static_cast<std::size_t>(triangle)];
    const Vec3 n = (points[b] - points[a]).cross(points[c] - points[a]);
    const double length = n.norm();
    return length > 0.0 ? Vec3(n / length) : n;
}

}  // namespace mq::layered_depth

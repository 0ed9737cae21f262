// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/deviation_samples.h"

#include <algorithm>
#include <cmath>

#include "mesh/edge_table.h"

namespace mq::mesh {

namespace {

// Points inside of large triangles at most, on the whole mesh.
constexpr double kInside = 4000.0;

// A mesh of few triangles can deviate from a wavy surface everywhere but at their corners, middles and centroids. Each
// triangle gets points in proportion to its area, however long it is: display meshes consist of needles.
void add_inside(const TriangleMesh& mesh, DeviationSamples& samples) {
    const auto corner = [&](std::size_t t, std::size_t k) -> const Vec3& {
        return mesh.vertices[mesh.triangles[t][k]];
    };
    const auto area_of = [&](std::size_t t) {
        return 0.5 * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
    };
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        area += area_of(t);
    }
    for (std::size_t t = 0; t < mesh.triangles.size() && area > 0.0; ++t) {
        const int parts = static_cast<int>(std::sqrt(2.0 * kInside * area_of(t) / area));
        for (int i = 1; i < parts - 1; ++i) {
            for (int k = 1; i + k < parts; ++k) {
                const Vec3 p = (i * corner(t, 0) + k * corner(t, 1) + (parts - i - k) * corner(t, 2)) / parts;
                samples.points.push_back(p + mesh.origin);
                samples.inside_of.push_back(static_cast<std::uint32_t>(t));
            }
        }
    }
}

}  // namespace

DeviationSamples deviation_samples(const TriangleMesh& mesh) {
    // The vertex has no sample point yet.
    constexpr std::uint32_t kUnused = UINT32_MAX;
    DeviationSamples samples;
    samples.of_triangle.resize(mesh.triangles.size());
    std::vector<std::uint32_t> point_of(mesh.vertices.size(), kUnused);
    const auto add = [&](const Vec3& p) {
        samples.points.push_back(p + mesh.origin);
        return static_cast<std::uint32_t>(samples.points.size() - 1);
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<std::uint32_t, 7>& own = samples.of_triangle[t];
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t v = mesh.triangles[t][i];
            sum += mesh.vertices[v];
            if (point_of[v] == kUnused) {
                point_of[v] = add(mesh.vertices[v]);
            }
            own[i] = point_of[v];
        }
        // Triangles that name a vertex twice are not in the table of edges below.
        own.back() = own[3] = own[4] = own[5] = add(sum / 3.0);
    }
    const EdgeTable edges(mesh.triangles, mesh.vertices.size());
    edges.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
        const std::uint32_t middle = add(0.5 * (mesh.vertices[low] + mesh.vertices[high]));
        std::for_each(first, last,
                      [&](std::uint32_t corner) { samples.of_triangle[corner / 3][3 + corner % 3] = middle; });
    });
    add_inside(mesh, samples);
    return samples;
}

std::vector<double> DeviationSamples::largest(const std::vector<double>& at_points) const {
    std::vector<double> result(of_triangle.size(), 0.0);
    for (std::size_t t = 0; t < result.size(); ++t) {
        for (const std::uint32_t p : of_triangle[t]) {
            result[t] = std::max(result[t], at_points[p]);
        }
    }
    const std::size_t first = at_points.size() - inside_of.size();
    for (std::size_t i = 0; i < inside_of.size(); ++i) {
        result[inside_of[i]] = std::max(result[inside_of[i]], at_points[first + i]);
    }
    return result;
}

}  // namespace mq::mesh

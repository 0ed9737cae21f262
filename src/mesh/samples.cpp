// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/samples.h"

#include <algorithm>

#include "mesh/edge_table.h"

namespace mq::mesh {

DeviationSamples deviation_samples(const TriangleMesh& mesh) {
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
    return samples;
}

std::vector<double> DeviationSamples::largest(const std::vector<double>& at_points) const {
    std::vector<double> result(of_triangle.size(), 0.0);
    for (std::size_t t = 0; t < result.size(); ++t) {
        for (const std::uint32_t p : of_triangle[t]) {
            result[t] = std::max(result[t], at_points[p]);
        }
    }
    return result;
}

}  // namespace mq::mesh

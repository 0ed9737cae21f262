// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/samples.h"

#include "mesh/edge_table.h"

namespace mq::mesh {

std::vector<Vec3> deviation_samples(const TriangleMesh& mesh) {
    std::vector<Vec3> samples;
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const Triangle& t : mesh.triangles) {
        Vec3 sum = Vec3::Zero();
        for (const std::int32_t v : t) {
            sum += mesh.vertices[v];
            if (!used[v]) {
                used[v] = true;
                samples.push_back(mesh.vertices[v] + mesh.origin);
            }
        }
        samples.push_back(sum / 3.0 + mesh.origin);
    }
    const EdgeTable edges(mesh.triangles, mesh.vertices.size());
    edges.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t*, const std::uint32_t*) {
        samples.push_back(0.5 * (mesh.vertices[low] + mesh.vertices[high]) + mesh.origin);
    });
    return samples;
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/edge_table.h"

#include <string>

#include "base/error.h"
namespace mq::mesh {

EdgeTable::EdgeTable(const std::vector<Triangle>& triangles, std::size_t vertex_count)
    : buckets_(edge_buckets(triangles, vertex_count, [](const EdgeEntry*, const EdgeEntry*) {})) {}

void require_valid(const TriangleMesh& mesh) {
    const auto count = static_cast<std::int64_t>(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (!mesh.vertices[v].allFinite()) {
            throw InvalidInput("vertex " + std::to_string(v) + " has a coordinate that is not a finite number");
        }
    }
    if (!mesh.origin.allFinite()) {
        throw InvalidInput("the mesh's origin has a coordinate that is not a finite number");
    }
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        for (const std::int32_t v : mesh.triangles[k]) {
            if (v < 0 || v >= count) {
                throw InvalidInput("triangle " + std::to_string(k) + " names vertex " + std::to_string(v) +
                                   ", but the mesh has " + std::to_string(count) + " vertices");
            }
        }
    }
    if (!mesh.triangle_face.empty() && mesh.triangle_face.size() != mesh.triangles.size()) {
        throw InvalidInput("the mesh has " + std::to_string(mesh.triangle_face.size()) + " face numbers for " +
                           std::to_string(mesh.triangles.size()) + " triangles; give one each, or none");
    }
    if (!mesh.vertex_entity.empty() && mesh.vertex_entity.size() != mesh.vertices.size()) {
        throw InvalidInput("the mesh has " + std::to_string(mesh.vertex_entity.size()) + " vertex entities for " +
                           std::to_string(mesh.vertices.size()) + " vertices; give one each, or none");
    }
}

}  // namespace mq::mesh

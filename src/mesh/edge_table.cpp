// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/edge_table.h"

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
namespace mq::mesh {

EdgeTable::EdgeTable(const std::vector<Triangle>& triangles, std::size_t vertex_count)
    : buckets_(edge_buckets(triangles, vertex_count, [](const EdgeEntry*, const EdgeEntry*) {})) {}

void require_valid(const TriangleMesh& mesh) {
    const auto count = static_cast<std::int64_t>(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (!mesh.vertices[v].allFinite()) {
            throw InvalidInput(phrases::kVertexNotFinite, {{"count", v}});
        }
    }
    if (!mesh.origin.allFinite()) {
        throw InvalidInput(phrases::kOriginNotFinite);
    }
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        for (const std::int32_t v : mesh.triangles[k]) {
            if (v < 0 || v >= count) {
                throw InvalidInput(phrases::kNoSuchVertex, {{"count", k}, {"count2", v}, {"count3", count}});
            }
        }
    }
    if (!mesh.triangle_face.empty() && mesh.triangle_face.size() != mesh.triangles.size()) {
        throw InvalidInput(
            phrases::kOneForEach,
            {{"name", "triangle_face"}, {"count", mesh.triangle_face.size()}, {"count2", mesh.triangles.size()}});
    }
    if (!mesh.vertex_entity.empty() && mesh.vertex_entity.size() != mesh.vertices.size()) {
        throw InvalidInput(
            phrases::kOneForEach,
            {{"name", "vertex_entity"}, {"count", mesh.vertex_entity.size()}, {"count2", mesh.vertices.size()}});
    }
}

}  // namespace mq::mesh

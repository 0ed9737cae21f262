// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/edge_table.h"

#include <algorithm>
#include <string>

#include "base/error.h"

namespace mq::mesh {

EdgeTable::EdgeTable(const std::vector<Triangle>& triangles, std::size_t vertex_count) : begin_(vertex_count + 1, 0) {
    for (const Triangle& t : triangles) {
        if (!collapsed(t)) {
            for (int i = 0; i < 3; ++i) {
                ++begin_[std::min(t[i], t[(i + 1) % 3]) + 1];
            }
        }
    }
    for (std::size_t v = 0; v < vertex_count; ++v) {
        begin_[v + 1] += begin_[v];
    }
    struct Entry {
        std::int32_t high;
        std::uint32_t corner;
    };
    std::vector<Entry> entries(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const Triangle& t = triangles[k];
        if (!collapsed(t)) {
            for (int i = 0; i < 3; ++i) {
                const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
                entries[next[low]++] = {high, static_cast<std::uint32_t>(3 * k + i)};
            }
        }
    }
    for (std::size_t v = 0; v < vertex_count; ++v) {
        std::sort(entries.begin() + begin_[v], entries.begin() + begin_[v + 1], [](const Entry& a, const Entry& b) {
            return a.high != b.high ? a.high < b.high : a.corner < b.corner;
        });
    }
    high_.reserve(entries.size());
    corners_.reserve(entries.size());
    for (const Entry& entry : entries) {
        high_.push_back(entry.high);
        corners_.push_back(entry.corner);
    }
}

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

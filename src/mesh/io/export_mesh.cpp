// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/export_mesh.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/edge_table.h"

namespace mq::mesh {

std::vector<std::vector<std::int32_t>> Elements::by_group(std::size_t groups) const {
    std::vector<std::size_t> counts(groups, 0);
    for (const std::int32_t g : group) {
        ++counts[static_cast<std::size_t>(g)];
    }
    std::vector<std::vector<std::int32_t>> found(groups);
    for (std::size_t g = 0; g < groups; ++g) {
        found[g].reserve(counts[g]);
    }
    for (std::size_t k = 0; k < group.size(); ++k) {
        found[static_cast<std::size_t>(group[k])].push_back(static_cast<std::int32_t>(k));
    }
    return found;
}

std::vector<std::vector<std::int32_t>> ExportMesh::nodes_by_patch() const {
    std::vector<std::vector<std::int32_t>> found;
    std::vector<std::size_t> last(nodes.size(), 0);  // the last patch with the node, from 1
    for (const auto& patch : triangles().by_group(patches().size())) {
        std::vector<std::int32_t>& of_patch = found.emplace_back();
        for (const std::int32_t k : patch) {
            const std::int32_t* t = triangles().of(static_cast<std::size_t>(k));
            for (std::size_t i = 0; i < triangles().width; ++i) {
                std::size_t& seen = last[static_cast<std::size_t>(t[i])];
                if (seen != found.size()) {
                    seen = found.size();
                    of_patch.push_back(t[i]);
                }
            }
        }
        std::sort(of_patch.begin(), of_patch.end());
    }
    return found;
}

void set_patches(ExportMesh& mesh, const Patches& patches) {
    Elements& triangles = mesh.elements[2];
    const std::size_t count = triangles.nodes.size() / triangles.width;
    mesh.patches_given = patches.given;
    if (patches.groups.empty()) {
        triangles.group.assign(count, 0);
        mesh.groups[2] = {Group{"Surface"}};
        return;
    }
    if (patches.of_triangle.size() != count) {
        throw InvalidInput("there are " + std::to_string(patches.of_triangle.size()) + " patch numbers for " +
                           std::to_string(count) + " triangles: give one each");
    }
    for (const std::int32_t patch : patches.of_triangle) {
        if (patch < 0 || static_cast<std::size_t>(patch) >= patches.groups.size()) {
            throw InvalidInput("a triangle is in patch " + std::to_string(patch) + ", but there are " +
                               std::to_string(patches.groups.size()) + ", numbered from 0");
        }
    }
    triangles.group = patches.of_triangle;
    mesh.groups[2] = patches.groups;
}

ExportMesh exported(const TriangleMesh& mesh, const Patches& patches, double scale) {
    require_valid(mesh);
    ExportMesh made;
    made.origin = mesh.origin;
    made.scale = scale;
    made.nodes = mesh.vertices;
    made.node_entity = mesh.vertex_entity;
    made.corners = mesh.vertices.size();
    Elements& triangles = made.elements[2];
    triangles.width = 3;
    triangles.nodes.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        triangles.nodes.insert(triangles.nodes.end(), t.begin(), t.end());
    }
    triangles.entity = mesh.triangle_face;
    set_patches(made, patches);
    return made;
}

}  // namespace mq::mesh

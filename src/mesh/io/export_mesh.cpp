// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/export_mesh.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/edge_table.h"

namespace mq::mesh {

int ExportMesh::dimension() const {
    int highest = 0;
    for (const Elements& block : blocks) {
        highest = block.nodes.empty() ? highest : std::max(highest, block.type->dimension);
    }
    return highest == 0 ? 2 : highest;
}

int ExportMesh::order() const {
    int highest = 1;
    for (const Elements& block : blocks) {
        highest = std::max(highest, block.type->order);
    }
    return highest;
}

Indices ExportMesh::groups_of(const Elements& block, std::size_t k) const {
    const std::int32_t* group = block.group.data() + k;
    if (!is_given()) {
        return {group, group + 1};
    }
    const std::vector<std::int32_t>& set = sets[static_cast<std::size_t>(*group)];
    return {set.data(), set.data() + set.size()};
}

std::vector<NumberedElements> ExportMesh::numbered(int lowest, int highest) const {
    std::vector<NumberedElements> found;
    std::size_t first = 1;
    for (const Elements& block : blocks) {
        if (block.type->dimension >= lowest && block.type->dimension <= highest && block.size() > 0) {
            found.push_back({&block, first});
            first += block.size();
        }
    }
    return found;
}

std::vector<Members> divided(const ExportMesh& mesh, const std::vector<NumberedElements>& numbered) {
    std::vector<Members> found;
    if (numbered.empty() && mesh.is_given()) {
        return found;
    }
    const int dimension = numbered.empty() ? 2 : numbered.front().elements->type->dimension;
    for (const Group& group : mesh.groups[static_cast<std::size_t>(dimension)]) {
        found.push_back({group.name, {}, {}});
    }
    found.push_back({"others", {}, {}});
    for (const NumberedElements& block : numbered) {
        for (std::size_t k = 0; k < block.elements->size(); ++k) {
            const std::int32_t group = mesh.first_group(*block.elements, k);
            (group < 0 ? found.back() : found[static_cast<std::size_t>(group)]).elements.emplace_back(&block, k);
        }
    }
    const auto is_empty = [](const Members& group) { return group.elements.empty(); };
    found.erase(std::remove_if(mesh.is_given() ? found.begin() : found.end() - 1, found.end(), is_empty), found.end());
    return found;
}

std::vector<Members> members_of(const ExportMesh& mesh, const std::vector<NumberedElements>& numbered) {
    const std::size_t patches = mesh.groups[2].size();
    std::vector<Members> found;
    for (int dimension = 2; dimension <= (mesh.is_given() ? 2 : 3); ++dimension) {
        for (const Group& group : mesh.groups[static_cast<std::size_t>(dimension)]) {
            found.push_back({group.name, {}, {}});
        }
    }
    for (const NumberedElements& block : numbered) {
        const std::size_t before = !mesh.is_given() && block.elements->type->dimension == 3 ? patches : 0;
        for (std::size_t k = 0; k < block.elements->size(); ++k) {
            for (const std::int32_t g : mesh.groups_of(*block.elements, k)) {
                found[before + static_cast<std::size_t>(g)].elements.emplace_back(&block, k);
            }
        }
    }
    std::vector<const Members*> last(mesh.nodes.size(), nullptr);
    for (Members& group : found) {
        for (const auto& [block, k] : group.elements) {
            const ElementType& type = *block->elements->type;
            const std::int32_t* nodes = block->elements->of(static_cast<std::size_t>(k));
            for (std::size_t i = 0; i < type.nodes && type.dimension < 3; ++i) {
                if (std::exchange(last[static_cast<std::size_t>(nodes[i])], &group) != &group) {
                    group.nodes.push_back(nodes[i]);
                }
            }
        }
        std::sort(group.nodes.begin(), group.nodes.end());
    }
    return found;
}

std::size_t Properties::slot_of(const Elements& block, std::size_t k) const {
    const auto dimension = static_cast<std::size_t>(block.type->dimension);
    std::size_t first = 0;
    for (std::size_t lower = 1; lower < dimension; ++lower) {
        first += mesh_.groups[lower].size() + 1;
    }
    const std::int32_t group = mesh_.first_group(block, k);
    return first + (group < 0 ? mesh_.groups[dimension].size() : static_cast<std::size_t>(group));
}

Properties::Properties(const ExportMesh& mesh, const std::vector<NumberedElements>& blocks) : mesh_(mesh) {
    std::vector<bool> used(3 + mesh.groups[1].size() + mesh.groups[2].size() + mesh.groups[3].size(), false);
    for (const auto& [block, first] : blocks) {
        for (std::size_t k = 0; k < block->size(); ++k) {
            used[slot_of(*block, k)] = true;
        }
    }
    constexpr std::array<const char*, 4> kOthers{"", "other lines", "other faces", "other solids"};
    for (std::size_t d = 1; d <= 3; ++d) {
        for (std::size_t g = 0; g <= mesh.groups[d].size(); ++g) {
            const bool in_none = g == mesh.groups[d].size();
            if (used[number_.size()] || (!mesh.is_given() && d > 1 && !in_none)) {
                names_.push_back(in_none ? kOthers[d] : (d == 3 ? "solid " : "patch ") + mesh.groups[d][g].name);
            }
            number_.push_back(names_.size());
        }
    }
}

void set_patches(ExportMesh& mesh, const Patches& patches) {
    const auto found = std::find_if(mesh.blocks.rbegin(), mesh.blocks.rend(),
                                    [](const Elements& block) { return block.type->dimension == 2; });
    Elements& triangles = *found;
    const std::size_t count = triangles.size();
    mesh.patches_given = patches.given;
    if (patches.groups.empty()) {
        triangles.group.assign(count, 0);
        mesh.groups[2] = {Group{"Surface"}};
        return;
    }
    if (patches.of_triangle.size() != count) {
        throw InvalidInput(phrases::kOneForEach,
                           {{"name", "patches"}, {"count", patches.of_triangle.size()}, {"count2", count}});
    }
    for (const std::int32_t patch : patches.of_triangle) {
        if (patch < 0 || static_cast<std::size_t>(patch) >= patches.groups.size()) {
            throw InvalidInput(phrases::kNoSuchPatch, {{"count", patch}, {"count2", patches.groups.size()}});
        }
    }
    triangles.group = patches.of_triangle;
    mesh.groups[2] = patches.groups;
}

void set_groups(ExportMesh& mesh, const std::vector<NamedRows>& groups) {
    for (Elements& block : mesh.blocks) {
        block.group.assign(block.size(), 0);
    }
    mesh.sets = {{}};
    std::map<std::int32_t, std::int32_t> with;  // by set: the set with this group added
    for (const auto& [name, parts] : groups) {
        const auto number = static_cast<std::int32_t>(mesh.groups[2].size());
        mesh.groups[2].push_back({name});
        with.clear();
        for (const auto& [block, rows] : parts) {
            for (const std::int32_t k : rows) {
                std::int32_t& set = mesh.blocks.at(block).group.at(static_cast<std::size_t>(k));
                if (const auto& of_set = mesh.sets[static_cast<std::size_t>(set)];
                    !of_set.empty() && of_set.back() == number) {
                    continue;  // the element is listed twice
                }
                const auto [found, is_new] = with.try_emplace(set, static_cast<std::int32_t>(mesh.sets.size()));
                if (is_new) {
                    mesh.sets.push_back(mesh.sets[static_cast<std::size_t>(set)]);
                    mesh.sets.back().push_back(number);
                }
                set = found->second;
            }
        }
    }
    mesh.groups[1] = mesh.groups[3] = mesh.groups[2];
}

ExportMesh exported(const TriangleMesh& mesh, const Patches& patches, double scale) {
    require_valid(mesh);
    ExportMesh made;
    made.origin = mesh.origin;
    made.scale = scale;
    made.nodes = mesh.vertices;
    made.node_entity = mesh.vertex_entity;
    Elements& triangles = made.blocks.emplace_back();
    triangles.type = &element_type("triangle", 3);
    triangles.nodes.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        triangles.nodes.insert(triangles.nodes.end(), t.begin(), t.end());
    }
    triangles.entity = mesh.triangle_face;
    set_patches(made, patches);
    return made;
}

std::string entity_name(int dimension, int index) {
    static constexpr std::array<const char*, 4> kNames{"Vertex", "Edge", "Face", "Solid"};
    return kNames[static_cast<std::size_t>(dimension)] + std::to_string(index + 1);
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <map>
#include <utility>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

/// One entity of a Gmsh file: the elements on a CAD entity, or those of them that are in the same other groups.
struct Entity {
    std::vector<std::int32_t> groups;  ///< numbers of physical groups, from 1
    std::vector<std::int32_t> nodes;
    std::vector<std::pair<const NumberedElements*, std::vector<std::int32_t>>> elements;
    Box box;
};

using Tag = std::pair<int, int>;  ///< dimension, and number from 1

/// The entities by Gmsh's tags: the CAD entity's number from 1. Elements without CAD entity share the tag after the
/// last.
class Entities {
  public:
    Entities(const ExportMesh& mesh, const std::vector<NumberedElements>& blocks) : mesh_(mesh) {
        listed_.resize(mesh.nodes.size(), false);
        for (const NumberedElements& block : blocks) {
            int& unknown = unknown_[static_cast<std::size_t>(block.elements->type->dimension)];
            for (const std::int32_t entity : block.elements->entity) {
                unknown = std::max(unknown, entity + 2);
            }
        }
        for (const NumberedElements& block : blocks) {
            add(block);
        }
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
            if (mesh.nodes_by_entity) {
                const VertexEntity& entity = mesh.node_entity[i];
                add_node(at({entity[0], entity[1] + 1}), i);
            } else if (!listed_[i] && !all_.empty()) {
                all_.begin()->second.nodes.push_back(static_cast<std::int32_t>(i));  // Gmsh needs each under an entity
            }
        }
    }

    const std::map<Tag, Entity>& all() const { return all_; }

    std::map<Tag, std::string> names() const {
        std::map<Tag, std::string> found;
        for (const auto& [tag, entity] : all_) {
            for (const std::int32_t group : entity.groups) {
                found[{tag.first, group}] = name_of(tag.first, group, entity);
            }
        }
        return found;
    }

  private:
    /// Whether the mesh's groups become physical groups; else each CAD entity becomes one.
    bool has_groups(int dimension) const { return mesh_.is_given() || (dimension == 2 && mesh_.patches_given); }

    /// The name of the physical group with a number, one of those of an entity.
    std::string name_of(int dimension, int number, const Entity& entity) const {
        const std::vector<Group>& groups = mesh_.groups[static_cast<std::size_t>(dimension)];
        if (has_groups(dimension)) {
            return groups[static_cast<std::size_t>(number) - 1].name;
        }
        if (dimension == 2) {
            return entity_name(dimension, number - 1);
        }
        const auto& [block, members] = entity.elements.front();
        return groups[static_cast<std::size_t>(block->elements->group[static_cast<std::size_t>(members.front())])].name;
    }

    void add(const NumberedElements& block) {
        const Elements& elements = *block.elements;
        const int dimension = elements.type->dimension;
        const int unknown = unknown_[static_cast<std::size_t>(dimension)];
        Entity* entity = nullptr;
        std::pair<int, std::int32_t> last;
        for (std::size_t k = 0; k < elements.size(); ++k) {
            const bool known = !elements.entity.empty() && elements.entity[k] >= 0;
            const std::pair<int, std::int32_t> own{known ? elements.entity[k] + 1 : unknown,
                                                   has_groups(dimension) ? elements.group[k] : 0};
            if (entity == nullptr || own != last) {
                last = own;
                entity = &piece({dimension, own.first}, own.second);
                if (entity->elements.empty()) {
                    if (has_groups(dimension)) {
                        for (const std::int32_t group : mesh_.groups_of(elements, k)) {
                            entity->groups.push_back(group + 1);
                        }
                    } else if (known) {
                        entity->groups = {own.first};
                    }
                }
                if (entity->elements.empty() || entity->elements.back().first != &block) {
                    entity->elements.push_back({&block, {}});
                }
            }
            entity->elements.back().second.push_back(static_cast<std::int32_t>(k));
            for (std::size_t i = 0; i < elements.type->nodes && !mesh_.nodes_by_entity; ++i) {
                add_node(*entity, static_cast<std::size_t>(elements.of(k)[i]));
            }
        }
    }

    /// The Gmsh entity of the elements of a CAD entity in the same groups. Elements in other groups than the first
    /// element of the CAD entity form entities of their own, with tags after all others.
    Entity& piece(const Tag& tag, std::int32_t group) {
        if (group == first_group_.try_emplace(tag, group).first->second) {
            return all_[tag];
        }
        int& pieces = pieces_[static_cast<std::size_t>(tag.first)];
        const auto [found, is_new] = pieces_of_.try_emplace({tag, group}, pieces);
        pieces += is_new ? 1 : 0;
        return all_[{tag.first, unknown_[static_cast<std::size_t>(tag.first)] + 1 + found->second}];
    }

    /// The entity of a node. An entity without elements is also a physical group, unless it is a vertex, or groups are
    /// those of the mesh.
    Entity& at(const Tag& tag) {
        const auto [found, is_new] = all_.try_emplace(tag);
        if (is_new && tag.first > 0 && !has_groups(tag.first)) {
            found->second.groups = {tag.second};
        }
        return found->second;
    }

    void add_node(Entity& entity, std::size_t node) {
        entity.box.add(mesh_.point(node));
        if (!listed_[node]) {
            listed_[node] = true;
            entity.nodes.push_back(static_cast<std::int32_t>(node));
        }
    }

    const ExportMesh& mesh_;
    std::vector<bool> listed_;
    std::array<int, 4> unknown_{1, 1, 1, 1};
    std::array<int, 4> pieces_{};
    std::map<Tag, std::int32_t> first_group_;
    std::map<std::pair<Tag, std::int32_t>, int> pieces_of_;
    std::map<Tag, Entity> all_;
};

void append_entities(Output& out, const std::map<Tag, Entity>& entities) {
    std::array<int, 4> counts{};
    for (const auto& [tag, entity] : entities) {
        ++counts[static_cast<std::size_t>(tag.first)];
    }
    out += "$Entities";
    for (std::size_t i = 0; i < counts.size(); ++i) {
        out += (i == 0 ? "\n" : " ") + std::to_string(counts[i]);
    }
    out += '\n';
    for (const auto& [tag, entity] : entities) {
        Box box = entity.box;
        if (box.empty()) {
            box.add(Vec3::Zero());
        }
        out.append_number(tag.second);
        for (int i = 0; i < (tag.first > 0 ? 6 : 3); ++i) {
            out += ' ';
            out.append_number(i < 3 ? box.low[i] : box.high[i - 3]);
        }
        out += ' ';
        out.append_number(entity.groups.size());
        append_nodes(out, entity.groups.data(), entity.groups.size(), 0, ' ', tag.first > 0 ? " 0\n" : "\n");
    }
    out += "$EndEntities\n";
}

}  // namespace

void to_msh(Output& out, const ExportMesh& mesh) {
    const std::vector<NumberedElements> blocks = mesh.numbered(1);
    const Entities made(mesh, blocks);
    const std::map<Tag, Entity>& entities = made.all();
    const std::map<Tag, std::string> names = made.names();
    out += "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    if (!names.empty()) {
        out += "$PhysicalNames\n" + std::to_string(names.size()) + "\n";
        for (const auto& [group, name] : names) {
            out += std::to_string(group.first) + " " + std::to_string(group.second) + " \"" + name + "\"\n";
        }
        out += "$EndPhysicalNames\n";
    }
    append_entities(out, entities);
    const auto begin = [&](const char* section, std::size_t pieces, std::size_t count) {
        out += "$" + std::string(section) + "\n" + std::to_string(pieces) + " " + std::to_string(count) + " " +
               (count > 0 ? "1 " : "0 ") + std::to_string(count) + "\n";
    };
    begin("Nodes", entities.size(), entities.empty() ? 0 : mesh.nodes.size());
    std::size_t pieces = 0;
    for (const auto& [tag, entity] : entities) {
        pieces += entity.elements.size();
        out += std::to_string(tag.first) + " " + std::to_string(tag.second) + " 0 " +
               std::to_string(entity.nodes.size()) + "\n";
        for (const std::int32_t v : entity.nodes) {
            out.append_number(static_cast<long long>(v) + 1);
            out += '\n';
        }
        for (const std::int32_t v : entity.nodes) {
            append_point_text(out, mesh.point(static_cast<std::size_t>(v)));
        }
    }
    out += "$EndNodes\n";
    begin("Elements", pieces, count_of(blocks));
    std::size_t next = 1;  // number of the next element, by CAD entities; elements of other meshes keep their numbers
    for (const auto& [tag, entity] : entities) {
        for (const auto& [block, rows] : entity.elements) {
            const ElementType& type = *block->elements->type;
            out += std::to_string(tag.first) + " " + std::to_string(tag.second) + " " + std::to_string(type.gmsh) +
                   " " + std::to_string(rows.size()) + "\n";
            for (const std::int32_t k : rows) {
                out.append_number(mesh.nodes_by_entity ? next++ : block->first + static_cast<std::size_t>(k));
                append_nodes(out, block->elements->of(static_cast<std::size_t>(k)), type.nodes, 1);
            }
        }
    }
    out += "$EndElements\n";
}

}  // namespace mq::mesh

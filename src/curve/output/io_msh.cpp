// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>

#include "curve/output/curved_mesh.h"
#include "mesh/io/io_formats.h"

namespace mq::curve {

namespace {

/// The elements of one dimension by the entity that they lie on.
std::map<int, std::vector<std::size_t>> by_entity(const mesh::Elements& elements) {
    std::map<int, std::vector<std::size_t>> result;
    for (std::size_t i = 0; i < elements.entity.size(); ++i) {
        result[elements.entity[i]].push_back(i);
    }
    return result;
}

class Writer {
  public:
    Writer(mesh::Output& out, const mesh::ExportMesh& mesh) : out_(out), mesh_(mesh) {
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
            const mesh::VertexEntity& entity = mesh.node_entity[i];
            nodes_of_[{entity[0], entity[1]}].push_back(i);
        }
        for (int dimension = 1; dimension <= 3; ++dimension) {
            for (const auto& [entity, elements] : by_entity(of(dimension))) {
                nodes_of_.try_emplace({dimension, entity});
                if (dimension == 2) {
                    patch_of_[entity] = of(2).group[elements.front()];
                }
            }
        }
    }

    void run() {
        out_ += "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
        physical_names();
        entities();
        nodes();
        elements();
    }

  private:
    const mesh::Elements& of(int dimension) const { return mesh_.elements[static_cast<std::size_t>(dimension)]; }

    /// Number from 1 of the physical group of an entity: its patch where there are such, the entity itself otherwise; 0
    /// for a face without triangles, which is in no patch.
    int physical_of(const std::pair<int, int>& entity) const {
        if (entity.first != 2 || !mesh_.patches_given) {
            return entity.second + 1;
        }
        const auto found = patch_of_.find(entity.second);
        return found == patch_of_.end() ? 0 : found->second + 1;
    }

    void physical_names() {
        std::map<std::pair<int, int>, std::string> names;
        for (const auto& [entity, nodes] : nodes_of_) {
            const int group = physical_of(entity);
            if (entity.first > 0 && group > 0) {
                const bool patch = entity.first == 2 && mesh_.patches_given;
                names[{entity.first, group}] = patch ? mesh_.patches()[static_cast<std::size_t>(group - 1)].name
                                                     : name_of(entity.first, entity.second);
            }
        }
        out_ += "$PhysicalNames\n" + std::to_string(names.size()) + "\n";
        for (const auto& [group, name] : names) {
            out_ += std::to_string(group.first) + " " + std::to_string(group.second) + " \"" + name + "\"\n";
        }
        out_ += "$EndPhysicalNames\n";
    }

    Box box_of(const std::vector<std::size_t>& nodes) const {
        Box box;
        for (const std::size_t i : nodes) {
            box.add(mesh_.point(i));
        }
        if (nodes.empty()) {
            box.add(Vec3::Zero());
        }
        return box;
    }

    void entities() {
        std::array<int, 4> counts{};
        for (const auto& [entity, nodes] : nodes_of_) {
            ++counts[static_cast<std::size_t>(entity.first)];
        }
        out_ += "$Entities\n";
        for (std::size_t i = 0; i < 4; ++i) {
            out_ += std::to_string(counts[i]) + (i < 3 ? " " : "\n");
        }
        for (const auto& [entity, nodes] : nodes_of_) {
            const Box box = box_of(nodes);
            out_.append_number(entity.second + 1);
            for (Eigen::Index i = 0; i < 3; ++i) {
                out_ += ' ';
                out_.append_number(box.low[i]);
            }
            for (Eigen::Index i = 0; i < 3 && entity.first > 0; ++i) {
                out_ += ' ';
                out_.append_number(box.high[i]);
            }
            const int group = entity.first == 0 ? 0 : physical_of(entity);
            const std::string end = entity.first == 0 ? "\n" : " 0\n";
            out_ += group == 0 ? " 0" + end : " 1 " + std::to_string(group) + end;
        }
        out_ += "$EndEntities\n";
    }

    void nodes() {
        const std::string count = std::to_string(mesh_.nodes.size());
        out_ += "$Nodes\n" + std::to_string(nodes_of_.size()) + " " + count + " 1 " + count + "\n";
        for (const auto& [entity, nodes] : nodes_of_) {
            out_ += std::to_string(entity.first) + " " + std::to_string(entity.second + 1) + " 0 " +
                    std::to_string(nodes.size()) + "\n";
            for (const std::size_t i : nodes) {
                out_.append_number(i + 1);
                out_ += '\n';
            }
            for (const std::size_t i : nodes) {
                mesh::append_point_text(out_, mesh_.point(i));
            }
        }
        out_ += "$EndNodes\n";
    }

    void elements() {
        std::size_t blocks = 0;
        std::size_t all_elements = 0;
        for (int dimension = 1; dimension <= 3; ++dimension) {
            blocks += by_entity(of(dimension)).size();
            all_elements += of(dimension).entity.size();
        }
        const std::string count = std::to_string(all_elements);
        out_ += "$Elements\n" + std::to_string(blocks) + " " + count + " 1 " + count + "\n";
        std::size_t next = 1;
        for (int dimension = 1; dimension <= 3; ++dimension) {
            const mesh::Elements& all = of(dimension);
            for (const auto& [entity, elements] : by_entity(all)) {
                out_ += std::to_string(dimension) + " " + std::to_string(entity + 1) + " " +
                        std::to_string(mesh::gmsh_type(dimension, mesh_.order)) + " " +
                        std::to_string(elements.size()) + "\n";
                for (const std::size_t e : elements) {
                    out_.append_number(next++);
                    mesh::append_nodes(out_, all.of(e), all.width, 1);
                }
            }
        }
        out_ += "$EndElements\n";
    }

    mesh::Output& out_;
    const mesh::ExportMesh& mesh_;
    std::map<int, int> patch_of_;                                       // by CAD face
    std::map<std::pair<int, int>, std::vector<std::size_t>> nodes_of_;  // by dimension and entity
};

}  // namespace

void curved_msh(mesh::Output& out, const mesh::ExportMesh& mesh) {
    Writer(out, mesh).run();
}

}  // namespace mq::curve

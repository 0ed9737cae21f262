// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cstdio>

#include "curve/output/curved_mesh.h"

namespace mq::curve {

namespace {

/// Gmsh's element types by dimension and order.
int gmsh_type(int dimension, int order) {
    // Gmsh's type numbers; rows: dimension, columns: order.
    static constexpr std::array<std::array<int, 5>, 3> kTypes{
        {{1, 8, 26, 27, 28}, {2, 9, 21, 23, 25}, {4, 11, 29, 30, 31}}};
    return kTypes[static_cast<std::size_t>(dimension - 1)][static_cast<std::size_t>(order - 1)];
}

std::string name_of(int dimension, int index) {
    // FreeCAD's names of entities, by dimension.
    static constexpr std::array<const char*, 4> kNames{"Vertex", "Edge", "Face", "Solid"};
    return kNames[static_cast<std::size_t>(dimension)] + std::to_string(index + 1);
}

/// Elements of one dimension, sorted by the entity they lie on.
struct Group {
    int dimension;
    int per_element;
    const std::vector<std::int32_t>& nodes;
    const std::vector<std::int32_t>& entity;

    std::map<int, std::vector<std::size_t>> by_entity() const {
        std::map<int, std::vector<std::size_t>> result;
        for (std::size_t i = 0; i < entity.size(); ++i) {
            result[entity[i]].push_back(i);
        }
        return result;
    }
};

class Writer {
  public:
    explicit Writer(const CurvedMesh& mesh)
        : mesh_(mesh),
          groups_{{1, mesh.nodes_per_edge(), mesh.edges, mesh.edge_entity},
                  {2, mesh.nodes_per_triangle(), mesh.triangles, mesh.triangle_face},
                  {3, mesh.nodes_per_tetrahedron(), mesh.tetrahedra, mesh.tetrahedron_volume}} {
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
            const mesh::VertexEntity& entity = mesh.node_entity[i];
            nodes_of_[{entity[0], entity[1]}].push_back(i);
        }
        for (const Group& group : groups_) {
            for (const auto& [entity, elements] : group.by_entity()) {
                nodes_of_.try_emplace({group.dimension, entity});
            }
        }
    }

    std::string run() {
        out_ = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
        physical_names();
        entities();
        nodes();
        elements();
        return std::move(out_);
    }

  private:
    static std::string number(double value) {
        char text[32];
        std::snprintf(text, sizeof text, "%.17g", value);
        return text;
    }

    void physical_names() {
        std::string lines;
        int count = 0;
        for (const auto& [entity, nodes] : nodes_of_) {
            if (entity.first > 0) {
                lines += std::to_string(entity.first) + " " + std::to_string(entity.second + 1) + " \"" +
                         name_of(entity.first, entity.second) + "\"\n";
                ++count;
            }
        }
        out_ += "$PhysicalNames\n" + std::to_string(count) + "\n" + lines + "$EndPhysicalNames\n";
    }

    Box box_of(const std::vector<std::size_t>& nodes) const {
        Box box;
        for (const std::size_t i : nodes) {
            box.add(mesh_.nodes[i]);
        }
        if (nodes.empty()) {
            box.add(Vec3::Zero());
        }
        return box;
    }

    void entities() {
        std::array<int, 4> counts{};
        std::string lines;
        for (const auto& [entity, nodes] : nodes_of_) {
            ++counts[static_cast<std::size_t>(entity.first)];
            const Box box = box_of(nodes);
            lines += std::to_string(entity.second + 1);
            for (Eigen::Index i = 0; i < 3; ++i) {
                lines += " " + number(box.low[i]);
            }
            for (Eigen::Index i = 0; i < 3 && entity.first > 0; ++i) {
                lines += " " + number(box.high[i]);
            }
            lines += entity.first == 0 ? " 0\n" : " 1 " + std::to_string(entity.second + 1) + " 0\n";
        }
        out_ += "$Entities\n";
        for (std::size_t i = 0; i < 4; ++i) {
            out_ += std::to_string(counts[i]) + (i < 3 ? " " : "\n");
        }
        out_ += lines + "$EndEntities\n";
    }

    void nodes() {
        const std::string count = std::to_string(mesh_.nodes.size());
        out_ += "$Nodes\n" + std::to_string(nodes_of_.size()) + " " + count + " 1 " + count + "\n";
        for (const auto& [entity, nodes] : nodes_of_) {
            out_ += std::to_string(entity.first) + " " + std::to_string(entity.second + 1) + " 0 " +
                    std::to_string(nodes.size()) + "\n";
            for (const std::size_t i : nodes) {
                out_ += std::to_string(i + 1) + "\n";
            }
            for (const std::size_t i : nodes) {
                const Vec3& p = mesh_.nodes[i];
                out_ += number(p.x()) + " " + number(p.y()) + " " + number(p.z()) + "\n";
            }
        }
        out_ += "$EndNodes\n";
    }

    void elements() {
        std::string lines;
        std::size_t blocks = 0;
        std::size_t next = 1;
        for (const Group& group : groups_) {
            for (const auto& [entity, elements] : group.by_entity()) {
                ++blocks;
                lines += std::to_string(group.dimension) + " " + std::to_string(entity + 1) + " " +
                         std::to_string(gmsh_type(group.dimension, mesh_.order)) + " " +
                         std::to_string(elements.size()) + "\n";
                for (const std::size_t e : elements) {
                    lines += std::to_string(next++);
                    const auto per = static_cast<std::size_t>(group.per_element);
                    for (std::size_t k = 0; k < per; ++k) {
                        lines += " " + std::to_string(group.nodes[e * per + k] + 1);
                    }
                    lines += "\n";
                }
            }
        }
        const std::string count = std::to_string(next - 1);
        out_ += "$Elements\n" + std::to_string(blocks) + " " + count + " 1 " + count + "\n" + lines + "$EndElements\n";
    }

    const CurvedMesh& mesh_;
    std::vector<Group> groups_;
    std::map<std::pair<int, int>, std::vector<std::size_t>> nodes_of_;  // by dimension and entity
    std::string out_;
};

}  // namespace

std::string to_msh(const CurvedMesh& mesh) {
    return Writer(mesh).run();
}

}  // namespace mq::curve

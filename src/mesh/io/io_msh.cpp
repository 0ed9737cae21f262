// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

/// The nodes and triangles of one discrete surface of a Gmsh file.
struct Surface {
    std::vector<std::int32_t> nodes;
    std::vector<std::int32_t> triangles;
    Box box;
};

/// Surfaces by Gmsh tag: the CAD face's number from 1. Triangles without a face share the tag after the last one.
std::map<int, Surface> surfaces_of(const ExportMesh& mesh) {
    const auto& faces = mesh.triangles().entity;
    const int unknown = faces.empty() ? 1 : *std::max_element(faces.begin(), faces.end()) + 2;
    std::map<int, Surface> surfaces;
    std::unordered_map<int, std::int32_t> patch_of_face;
    std::map<std::pair<int, std::int32_t>, int> pieces;
    std::vector<bool> listed(mesh.nodes.size(), false);
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        int tag = faces.empty() || faces[k] < 0 ? unknown : faces[k] + 1;
        if (mesh.patches_given) {
            // A patch may hold a piece of a face: that is a surface of its own, after all faces.
            const auto patch = mesh.triangles().group[k];
            const int own = patch_of_face.try_emplace(tag, patch).first->second;
            tag = patch == own
                      ? tag
                      : pieces.emplace(std::make_pair(tag, patch), unknown + 1 + static_cast<int>(pieces.size()))
                            .first->second;
        }
        Surface& surface = surfaces[tag];
        surface.triangles.push_back(static_cast<std::int32_t>(k));
        for (std::size_t i = 0; i < 3; ++i) {
            const auto v = static_cast<std::size_t>(mesh.triangles().of(k)[i]);
            surface.box.add(mesh.point(v));
            if (!listed[v]) {
                listed[v] = true;
                surface.nodes.push_back(static_cast<std::int32_t>(v));
            }
        }
    }
    // Gmsh needs every node under an entity: nodes of no triangle are listed with the first surface.
    for (std::size_t v = 0; v < listed.size() && !surfaces.empty(); ++v) {
        if (!listed[v]) {
            surfaces.begin()->second.nodes.push_back(static_cast<std::int32_t>(v));
        }
    }
    return surfaces;
}

/// The number from 1 of the physical group of a surface: its patch where there are such, its CAD face otherwise; 0:
/// none.
int group_of(const ExportMesh& mesh, const Surface& surface) {
    const auto first = static_cast<std::size_t>(surface.triangles.front());
    if (mesh.patches_given) {
        return mesh.triangles().group[first] + 1;
    }
    return mesh.triangles().entity.empty() ? 0 : std::max(mesh.triangles().entity[first] + 1, 0);
}

void append_head(Output& out, const ExportMesh& mesh, const std::map<int, Surface>& surfaces) {
    out += "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    std::map<int, std::string> names;
    for (const auto& [tag, surface] : surfaces) {
        const int group = group_of(mesh, surface);
        if (group > 0) {
            names[group] = mesh.patches_given ? mesh.patches()[static_cast<std::size_t>(group) - 1].name
                                              : "Face" + std::to_string(group);
        }
    }
    if (!names.empty()) {
        out += "$PhysicalNames\n" + std::to_string(names.size()) + "\n";
        for (const auto& [group, name] : names) {
            out += "2 " + std::to_string(group) + " \"" + name + "\"\n";
        }
        out += "$EndPhysicalNames\n";
    }
    out += "$Entities\n0 0 " + std::to_string(surfaces.size()) + " 0\n";
    for (const auto& [tag, surface] : surfaces) {
        out.append_number(static_cast<long long>(tag));
        for (const Vec3* corner : {&surface.box.low, &surface.box.high}) {
            for (int i = 0; i < 3; ++i) {
                out += ' ';
                out.append_number((*corner)[i]);
            }
        }
        const int group = group_of(mesh, surface);
        out += group > 0 ? " 1 " + std::to_string(group) + " 0\n" : std::string(" 0 0\n");
    }
    out += "$EndEntities\n";
}

}  // namespace

void to_msh(Output& out, const ExportMesh& mesh) {
    const std::map<int, Surface> surfaces = surfaces_of(mesh);
    append_head(out, mesh, surfaces);
    const auto begin = [&](const char* section, std::size_t count) {
        out += "$" + std::string(section) + "\n" + std::to_string(surfaces.size()) + " " + std::to_string(count) + " " +
               (count > 0 ? "1 " : "0 ") + std::to_string(count) + "\n";
    };
    begin("Nodes", surfaces.empty() ? 0 : mesh.nodes.size());
    for (const auto& [tag, surface] : surfaces) {
        out += "2 " + std::to_string(tag) + " 0 " + std::to_string(surface.nodes.size()) + "\n";
        for (const std::int32_t v : surface.nodes) {
            out.append_number(static_cast<long long>(v) + 1);
            out += '\n';
        }
        for (const std::int32_t v : surface.nodes) {
            append_point_text(out, mesh.point(static_cast<std::size_t>(v)));
        }
    }
    out += "$EndNodes\n";
    begin("Elements", mesh.triangles().size());
    // Gmsh's number of a triangle with three nodes.
    constexpr const char* kThreeNodeTriangle = "2";
    for (const auto& [tag, surface] : surfaces) {
        out += "2 " + std::to_string(tag) + " " + kThreeNodeTriangle + " " + std::to_string(surface.triangles.size()) +
               "\n";
        for (const std::int32_t k : surface.triangles) {
            out.append_number(static_cast<long long>(k) + 1);
            append_nodes(out, mesh.triangles().of(static_cast<std::size_t>(k)), 3, 1);
        }
    }
    out += "$EndElements\n";
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <numeric>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

template <typename T>
void append_chars(std::string& out, T value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    out.append(buffer.data(), end);
}

void append_triangle(std::string& out, const Triangle& t, int first) {
    for (const std::int32_t v : t) {
        out += ' ';
        append_number(out, static_cast<long long>(v) + first);
    }
    out += '\n';
}

}  // namespace

void append_number(std::string& out, double value) {
    append_chars(out, value);
}
void append_number(std::string& out, long long value) {
    append_chars(out, value);
}

void append_point_text(std::string& out, const Vec3& p) {
    for (int i = 0; i < 3; ++i) {
        append_number(out, p[i]);
        out += i < 2 ? ' ' : '\n';
    }
}

std::string to_obj(const TriangleMesh& mesh) {
    std::string out = "# MeshQuality\n";
    for (const Vec3& p : mesh.vertices) {
        out += "v ";
        append_point_text(out, p + mesh.origin);
    }
    std::int32_t group = -1;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        if (!mesh.triangle_face.empty() && mesh.triangle_face[k] != group) {
            group = mesh.triangle_face[k];
            out += "g Face" + std::to_string(group + 1) + "\n";
        }
        out += 'f';
        append_triangle(out, mesh.triangles[k], 1);
    }
    return out;
}

std::string to_off(const TriangleMesh& mesh) {
    std::string out =
        "OFF\n" + std::to_string(mesh.vertices.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
    for (const Vec3& p : mesh.vertices) {
        append_point_text(out, p + mesh.origin);
    }
    for (const Triangle& t : mesh.triangles) {
        out += '3';
        append_triangle(out, t, 0);
    }
    return out;
}

namespace {

/// The nodes and triangles of one discrete surface of a Gmsh file.
struct Surface {
    std::vector<std::int32_t> nodes;
    std::vector<std::int32_t> triangles;
    Box box;
};

/// Surfaces by Gmsh tag: the CAD face's number from 1. Triangles without a face share the tag after the last one.
std::map<int, Surface> surfaces_of(const TriangleMesh& mesh) {
    const auto& faces = mesh.triangle_face;
    const int unknown = faces.empty() ? 1 : *std::max_element(faces.begin(), faces.end()) + 2;
    std::map<int, Surface> surfaces;
    std::vector<bool> listed(mesh.vertices.size(), false);
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const int tag = faces.empty() || faces[k] < 0 ? unknown : faces[k] + 1;
        Surface& surface = surfaces[tag];
        surface.triangles.push_back(static_cast<std::int32_t>(k));
        for (const std::int32_t v : mesh.triangles[k]) {
            surface.box.add(mesh.vertices[v] + mesh.origin);
            if (!listed[v]) {
                listed[v] = true;
                surface.nodes.push_back(v);
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

std::string msh_head(const TriangleMesh& mesh, const std::map<int, Surface>& surfaces) {
    std::string out = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    const auto named = [&](const Surface& s) {
        return !mesh.triangle_face.empty() && mesh.triangle_face[s.triangles.front()] >= 0;
    };
    const auto count = std::count_if(surfaces.begin(), surfaces.end(), [&](const auto& s) { return named(s.second); });
    if (count > 0) {
        out += "$PhysicalNames\n" + std::to_string(count) + "\n";
        for (const auto& [tag, surface] : surfaces) {
            if (named(surface)) {
                out += "2 " + std::to_string(tag) + " \"Face" + std::to_string(tag) + "\"\n";
            }
        }
        out += "$EndPhysicalNames\n";
    }
    out += "$Entities\n0 0 " + std::to_string(surfaces.size()) + " 0\n";
    for (const auto& [tag, surface] : surfaces) {
        append_number(out, static_cast<long long>(tag));
        for (const Vec3* corner : {&surface.box.low, &surface.box.high}) {
            for (int i = 0; i < 3; ++i) {
                out += ' ';
                append_number(out, (*corner)[i]);
            }
        }
        out += named(surface) ? " 1 " + std::to_string(tag) + " 0\n" : std::string(" 0 0\n");
    }
    return out + "$EndEntities\n";
}

}  // namespace

std::string to_msh(const TriangleMesh& mesh) {
    const std::map<int, Surface> surfaces = surfaces_of(mesh);
    std::string out = msh_head(mesh, surfaces);
    const auto begin = [&](const char* section, std::size_t count) {
        out += "$" + std::string(section) + "\n" + std::to_string(surfaces.size()) + " " + std::to_string(count) + " " +
               (count > 0 ? "1 " : "0 ") + std::to_string(count) + "\n";
    };
    begin("Nodes", surfaces.empty() ? 0 : mesh.vertices.size());
    for (const auto& [tag, surface] : surfaces) {
        out += "2 " + std::to_string(tag) + " 0 " + std::to_string(surface.nodes.size()) + "\n";
        for (const std::int32_t v : surface.nodes) {
            append_number(out, static_cast<long long>(v) + 1);
            out += '\n';
        }
        for (const std::int32_t v : surface.nodes) {
            append_point_text(out, mesh.vertices[v] + mesh.origin);
        }
    }
    out += "$EndNodes\n";
    begin("Elements", mesh.triangles.size());
    // Gmsh's number of a triangle with three nodes.
    constexpr const char* kThreeNodeTriangle = "2";
    for (const auto& [tag, surface] : surfaces) {
        out += "2 " + std::to_string(tag) + " " + kThreeNodeTriangle + " " + std::to_string(surface.triangles.size()) +
               "\n";
        for (const std::int32_t k : surface.triangles) {
            append_number(out, static_cast<long long>(k) + 1);
            append_triangle(out, mesh.triangles[k], 1);
        }
    }
    return out + "$EndElements\n";
}

}  // namespace mq::mesh

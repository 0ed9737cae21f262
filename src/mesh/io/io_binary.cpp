// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "mesh/edge_table.h"
#include "mesh/io/io.h"
#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

Vec3 normal_of(const ExportMesh& mesh, const std::int32_t* t) {
    const Vec3& a = mesh.nodes[static_cast<std::size_t>(t[0])];
    const Vec3 cross =
        (mesh.nodes[static_cast<std::size_t>(t[1])] - a).cross(mesh.nodes[static_cast<std::size_t>(t[2])] - a);
    const double length = cross.norm();
    return length > 0.0 ? Vec3(cross / length) : Vec3::Zero();
}

/// The text " x y z\n" of each node, made once, as a node is a corner of about six triangles.
class PointTexts {
  public:
    explicit PointTexts(const ExportMesh& mesh) {
        Output out([&](const char* bytes, std::size_t count) { texts_.append(bytes, count); });
        const bool single = fits_single_precision(mesh);
        ends_.reserve(mesh.nodes.size() + 1);
        ends_.push_back(0);
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
            const Vec3 p = mesh.point(i);
            for (int axis = 0; axis < 3; ++axis) {
                out += ' ';
                if (single) {
                    out.append_number(static_cast<float>(p[axis]));
                } else {
                    out.append_number(p[axis]);
                }
            }
            out += '\n';
            ends_.push_back(out.size());
        }
        out.flush();
    }

    std::string_view of(std::size_t node) const {
        return std::string_view(texts_).substr(ends_[node], ends_[node + 1] - ends_[node]);
    }

  private:
    std::string texts_;
    std::vector<std::size_t> ends_;
};

}  // namespace

bool fits_single_precision(const ExportMesh& mesh) {
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k) {
        const Vec3 p = mesh.point(k);
        for (int i = 0; i < 3; ++i) {
            if (static_cast<double>(static_cast<float>(p[i])) != p[i]) {
                return false;
            }
        }
    }
    return true;
}

void to_stl(Output& out, const ExportMesh& mesh) {
    constexpr std::int32_t kMostPatches = 0x7fff;  // the highest bit makes a colour of the attribute
    const Elements& triangles = mesh.triangles();
    const std::string head = "MeshQuality";
    out += head;
    out.append(80 - head.size(), ' ');
    append_bytes(out, static_cast<std::uint32_t>(triangles.size()));
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const std::int32_t* t = triangles.of(k);
        append_point<float>(out, normal_of(mesh, t));
        for (std::size_t i = 0; i < 3; ++i) {
            append_point<float>(out, mesh.point(static_cast<std::size_t>(t[i])));
        }
        const std::int32_t attribute = mesh.patches_given ? std::min(triangles.group[k], kMostPatches) : 0;
        append_bytes(out, static_cast<std::uint16_t>(attribute));
    }
}

void to_stl_text(Output& out, const ExportMesh& mesh) {
    const PointTexts points(mesh);
    const auto triangles = mesh.numbered(2);
    for (const Members& patch : divided(mesh, triangles)) {
        out += "solid " + patch.name + "\n";
        for (const auto& [block, k] : patch.elements) {
            const std::int32_t* t = mesh.triangles().of(static_cast<std::size_t>(k));
            const Vec3 normal = normal_of(mesh, t);
            out += "facet normal";
            for (int i = 0; i < 3; ++i) {
                out += ' ';
                out.append_number(static_cast<float>(normal[i]));
            }
            out += "\nouter loop\n";
            for (std::size_t i = 0; i < 3; ++i) {
                out += "vertex";
                out += points.of(static_cast<std::size_t>(t[i]));
            }
            out += "endloop\nendfacet\n";
        }
        out += "endsolid " + patch.name + "\n";
    }
}

void to_ply(Output& out, const ExportMesh& mesh) {
    const bool single = fits_single_precision(mesh);
    const Elements& triangles = mesh.triangles();
    const bool has_face = mesh.patches_given && !triangles.entity.empty();
    const std::string real = single ? "float" : "double";
    out += "ply\nformat binary_little_endian 1.0\ncomment MeshQuality\n";
    for (std::size_t p = 0; mesh.patches_given && p < mesh.patches().size(); ++p) {
        out += "comment patch " + std::to_string(p) + " " + mesh.patches()[p].name + "\n";
    }
    out += "element vertex " + std::to_string(mesh.nodes.size()) + "\n";
    for (const char* axis : {"x", "y", "z"}) {
        out += "property " + real + " " + axis + "\n";
    }
    out += "element face " + std::to_string(triangles.size()) + "\nproperty list uchar int vertex_indices\n";
    out += std::string(has_face ? "property int face\n" : "") + (mesh.patches_given ? "property int patch\n" : "");
    out += "end_header\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        if (single) {
            append_point<float>(out, mesh.point(i));
        } else {
            append_point<double>(out, mesh.point(i));
        }
    }
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        append_bytes(out, std::uint8_t{3});
        out.append(reinterpret_cast<const char*>(triangles.of(k)), 3 * sizeof(std::int32_t));
        if (has_face) {
            append_bytes(out, triangles.entity[k]);
        }
        if (mesh.patches_given) {
            append_bytes(out, triangles.group[k]);
        }
    }
}

namespace {

/// FreeCAD's mark for an edge without a neighbour.
constexpr std::uint32_t kNoNeighbour = std::numeric_limits<std::uint32_t>::max();

/// For each corner the triangle across its edge. An edge of three or more triangles has no unique neighbour: none.
std::vector<std::uint32_t> neighbours_of(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> neighbours(3 * mesh.triangles.size(), kNoNeighbour);
    const EdgeTable table(mesh.triangles, mesh.vertices.size());
    table.for_each([&](std::int32_t, std::int32_t, const std::uint32_t* first, const std::uint32_t* last) {
        if (last - first == 2) {
            neighbours[first[0]] = first[1] / 3;
            neighbours[first[1]] = first[0] / 3;
        }
    });
    return neighbours;
}

}  // namespace

// Layout, as FreeCAD's Mesh module writes and reads it: magic, version, 256 characters of comment, number of points,
// number of facets; x y z of each point; three points and three neighbours of each facet; the box as low, high of
// each axis.
std::string to_bms(const TriangleMesh& mesh) {
    require_valid(mesh);
    std::string out;
    out.reserve(304 + 12 * mesh.vertices.size() + 24 * mesh.triangles.size());
    append_bytes(out, std::uint32_t{0xA0B0C0D0});
    append_bytes(out, std::uint32_t{0x010000});
    std::string comment = "MeshQuality";
    comment.resize(255, ' ');
    out += comment + "\n";
    append_bytes(out, static_cast<std::uint32_t>(mesh.vertices.size()));
    append_bytes(out, static_cast<std::uint32_t>(mesh.triangles.size()));
    Box box;
    for (const Vec3& p : mesh.vertices) {
        append_point<float>(out, p);
        box.add(p);
    }
    const std::vector<std::uint32_t> neighbours = neighbours_of(mesh);
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        append_bytes(out, mesh.triangles[k]);
        for (int i = 0; i < 3; ++i) {
            append_bytes(out, neighbours[3 * k + i]);
        }
    }
    for (int i = 0; i < 3; ++i) {
        append_bytes(out, static_cast<float>(box.empty() ? 0.0 : box.low[i]));
        append_bytes(out, static_cast<float>(box.empty() ? 0.0 : box.high[i]));
    }
    return out;
}

}  // namespace mq::mesh

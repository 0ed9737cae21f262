// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <limits>

#include "mesh/edge_table.h"
#include "mesh/io/io.h"
#include "mesh/io/io_formats.h"

namespace mq::mesh {

bool fits_single_precision(const TriangleMesh& mesh) {
    for (const Vec3& p : mesh.vertices) {
        for (int i = 0; i < 3; ++i) {
            const double value = p[i] + mesh.origin[i];
            if (static_cast<double>(static_cast<float>(value)) != value) {
                return false;
            }
        }
    }
    return true;
}

std::string to_stl(const TriangleMesh& mesh) {
    std::string out = "MeshQuality";
    out.resize(80, ' ');
    out.reserve(84 + 50 * mesh.triangles.size());
    append_bytes(out, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3 cross = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
        const double length = cross.norm();
        append_point<float>(out, length > 0.0 ? Vec3(cross / length) : Vec3::Zero());
        for (const std::int32_t v : t) {
            append_point<float>(out, mesh.vertices[v] + mesh.origin);
        }
        append_bytes(out, std::uint16_t{0});
    }
    return out;
}

std::string to_ply(const TriangleMesh& mesh) {
    const bool single = fits_single_precision(mesh);
    const std::string real = single ? "float" : "double";
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment MeshQuality\nelement vertex " +
                      std::to_string(mesh.vertices.size()) + "\n";
    for (const char* axis : {"x", "y", "z"}) {
        out += "property " + real + " " + axis + "\n";
    }
    out += "element face " + std::to_string(mesh.triangles.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
    out.reserve(out.size() + 24 * mesh.vertices.size() + 13 * mesh.triangles.size());
    for (const Vec3& p : mesh.vertices) {
        if (single) {
            append_point<float>(out, p + mesh.origin);
        } else {
            append_point<double>(out, p + mesh.origin);
        }
    }
    for (const Triangle& t : mesh.triangles) {
        append_bytes(out, std::uint8_t{3});
        append_bytes(out, t);
    }
    return out;
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

#include "base/stopwatch.h"
#include "layered_depth/layered_depth_boolean.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/io/io.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/quality/surface_distance.h"

/// The uniform scheme on two binary PLY files:   ldi_bench A.ply B.ply OPERATION [-r RAYS]... [-o OUT] [-e EXACT.ply]
/// prints for each resolution the seconds of each stage, what was retained and reconstructed, what a check of the
/// result finds, and with -e its distance from the exact result, in per cent of the diagonal, both ways.
namespace {

using namespace mq;

template <typename Number>
Vec3 read_point(std::istream& file) {
    std::array<Number, 3> xyz{};
    file.read(reinterpret_cast<char*>(xyz.data()), sizeof xyz);
    return Vec3(xyz[0], xyz[1], xyz[2]);
}

/// Reads what the benchmark's meshes are: binary little-endian PLY, x y z in either precision, triangles with one-byte
/// counts and four-byte indices.
mesh::TriangleMesh read_ply(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::size_t vertices = 0, triangles = 0;
    std::string line;
    bool binary = false, is_double = false;
    while (std::getline(file, line) && line != "end_header") {
        std::istringstream words(line);
        std::string a, b;
        words >> a >> b;
        binary = binary || b == "binary_little_endian";
        is_double = is_double || (a == "property" && b == "double");
        if (a == "element") {
            words >> (b == "vertex" ? vertices : triangles);
        }
    }
    mesh::TriangleMesh mesh;
    mesh.vertices.resize(vertices);
    for (Vec3& p : mesh.vertices) {
        p = is_double ? read_point<double>(file) : read_point<float>(file);
    }
    mesh.triangles.resize(triangles);
    for (mesh::Triangle& t : mesh.triangles) {
        file.get();
        file.read(reinterpret_cast<char*>(t.data()), sizeof t);
    }
    if (!file || !binary) {
        throw IoError(path + ": not a binary PLY file of triangles");
    }
    return mesh;
}

void print(const layered_depth::UniformResult& r, int resolution, double wall, double cpu) {
    std::printf("%d: %.3f s wall, %.3f s CPU |", resolution, wall, cpu);
    for (const auto& [name, seconds] : r.seconds) {
        std::printf(" %s %.3f", name.c_str(), seconds);
    }
    std::printf(
        "\n   samples %zu -> %zu, retained %zu, changed %zu, reconstructed %zu, filled %zu in %zu holes (%zu)\n",
        r.samples, r.result_samples, r.retained, r.changed, r.reconstructed, r.hole_triangles, r.holes_filled,
        r.largest_hole);
    std::printf(
        "   cells %zu, boundary %zu, complex %zu; edges split %zu, nodes collapsed %zu, moved %zu, left %zu; "
        "triangles refused %zu, nodes opened %zu, unsampled %zu\n",
        r.cells, r.boundary_cells, r.complex_cells, r.split_edges, r.collapsed_nodes, r.moved_nodes, r.left_nodes,
        r.refused_triangles, r.opened_nodes, r.unsampled_triangles);
}

void check(const layered_depth::UniformResult& r) {
    const mesh::MeshReport report = mesh::measure(r.mesh);
    std::printf("   check: border %zu, nonmanifold %zu, misoriented %zu, pinched %zu, degenerate %zu, volume %.9g\n",
                report.border_edges, report.nonmanifold_edges, report.misoriented_edges, report.pinched_vertices,
                report.degenerate_triangles, report.volume);
    std::vector<std::int32_t> made;
    for (std::size_t k = 0; k < r.triangle_source.size(); ++k) {
        if (r.triangle_source[k][0] < 0) {
            made.push_back(static_cast<std::int32_t>(k));
        }
    }
    std::printf("   pairs of triangles that cross or touch: %zu with one that was made, %zu in all\n",
                mesh::self_intersections_with(r.mesh.vertices, r.mesh.triangles, made).size(),
                mesh::self_intersections(r.mesh.vertices, r.mesh.triangles).size());
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> resolutions;
    std::string out, exact;
    for (int i = 4; i + 1 < argc; i += 2) {
        if (std::strcmp(argv[i], "-r") == 0) {
            resolutions.push_back(std::atoi(argv[i + 1]));
        } else {
            (std::strcmp(argv[i], "-o") == 0 ? out : exact) = argv[i + 1];
        }
    }
    if (argc < 4) {
        std::printf("usage: ldi_bench A.ply B.ply OPERATION [-r RAYS]... [-o OUT] [-e EXACT.ply]\n");
        return 2;
    }
    try {
        const mesh::TriangleMesh a = read_ply(argv[1]), b = read_ply(argv[2]);
        const boolean::Operation operation = boolean::operation_from(argv[3]);
        for (const int resolution : resolutions) {
            layered_depth::LayeredDepthOptions options;
            options.resolution = resolution;
            const auto start = std::chrono::steady_clock::now();
            const double cpu = cpu_seconds();
            const layered_depth::UniformResult r =
                layered_depth::layered_depth_boolean(a, b, operation, options, nullptr);
            const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
            print(r, resolution, wall.count(), cpu_seconds() - cpu);
            check(r);
            if (!out.empty()) {
                mesh::write(r.mesh, out);
            }
            if (!exact.empty()) {
                const mesh::TriangleMesh reference = read_ply(exact);
                Box box;
                for (const Vec3& p : reference.vertices) {
                    box.add(p);
                }
                const double per_cent = 100.0 / (box.high - box.low).norm();
                const mesh::SurfaceDistance to = mesh::surface_distance(r.mesh, reference, Progress());
                const mesh::SurfaceDistance from = mesh::surface_distance(reference, r.mesh, Progress());
                std::printf("   error %%: mean %.3g max %.3g, back mean %.3g max %.3g; bound %.3g\n",
                            to.mean * per_cent, to.largest * per_cent, from.mean * per_cent, from.largest * per_cent,
                            r.error_bound * per_cent);
            }
        }
    } catch (const Error& error) {
        std::printf("%s\n", error.what());
        return 1;
    }
    return 0;
}

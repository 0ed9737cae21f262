// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/feature_edges.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/angle.h"
#include "mesh/edge_table.h"

namespace mq::mesh {

namespace {

std::vector<Vec3> normals_of(const ExportMesh& mesh, const std::vector<Triangle>& triangles) {
    std::vector<Vec3> normals;
    normals.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        const auto node = [&](int i) { return mesh.nodes[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]; };
        normals.push_back((node(1) - node(0)).cross(node(2) - node(0)).normalized());
    }
    return normals;
}

}  // namespace

FeatureEdges feature_edges(const ExportMesh& mesh, double degrees) {
    std::vector<Triangle> triangles;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const std::int32_t* t = mesh.triangles().of(k);
        triangles.push_back({t[0], t[1], t[2]});
    }
    const std::vector<Vec3> normals = normals_of(mesh, triangles);
    const double least = std::cos(degrees * kDegree);
    FeatureEdges found;
    const EdgeTable table(triangles, mesh.nodes.size());
    table.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
        const std::uint32_t one = first[0] / 3;
        bool sharp = last - first != 2;
        bool border = false;
        for (const std::uint32_t* corner = first + 1; corner < last; ++corner) {
            const std::uint32_t other = *corner / 3;
            sharp = sharp || normals[one].dot(normals[other]) < least;
            border = border || mesh.triangles().group[one] != mesh.triangles().group[other];
        }
        if (sharp || border) {
            found.edges.push_back({low, high});
            found.sharp.push_back(sharp);
            found.border.push_back(border);
        }
    });
    return found;
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

TEST(DeviationSamples, CornersMiddlesAndCentroidsOnceEachInThePartsFrame) {
    TriangleMesh mesh = samples::tetrahedron();
    mesh.vertices.push_back(Vec3(9, 9, 9));  // of no triangle
    mesh.vertex_entity.clear();
    mesh.origin = Vec3(100, 0, 0);
    const std::vector<Vec3> found = deviation_samples(mesh).points;
    EXPECT_EQ(found.size(), 4u + 6u + 4u);
    for (const Vec3& expected : {Vec3(100, 0, 1), Vec3(100.5, 0.5, 0), Vec3(100, 0, 0.5)}) {
        EXPECT_EQ(std::count(found.begin(), found.end(), expected), 1);
    }
}

TEST(DeviationSamples, TellWhichPointsAreATriangles) {
    const TriangleMesh mesh = samples::tetrahedron();
    const DeviationSamples samples = deviation_samples(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto at = [&](std::size_t i) { return mesh.vertices[mesh.triangles[t][i % 3]]; };
        const auto point = [&](std::size_t i) { return samples.points[samples.of_triangle[t][i]]; };
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(point(i), at(i));
            EXPECT_EQ(point(3 + i), 0.5 * (at(i) + at(i + 1)));
        }
        EXPECT_TRUE(point(6).isApprox((at(0) + at(1) + at(2)) / 3.0));
    }
    // The largest value of a vertex's triangles is the vertex's.
    std::vector<double> values(samples.points.size(), 0.0);
    values[samples.of_triangle[0][0]] = 7.0;
    const std::vector<double> largest = samples.largest(values);
    EXPECT_EQ(std::count(largest.begin(), largest.end(), 7.0), 3);
    EXPECT_EQ(std::count(largest.begin(), largest.end(), 0.0), 1);
}

}  // namespace
}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/deviation_samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

TEST(DeviationSamples, CornersMiddlesAndCentroidsOnceEachInThePartsFrame) {
    TriangleMesh mesh = samples::tetrahedron();
    mesh.vertices.push_back(Vec3(9, 9, 9));  // a vertex of no triangle
    mesh.vertex_entity.clear();
    mesh.origin = Vec3(100, 0, 0);
    const DeviationSamples samples = deviation_samples(mesh);
    const std::vector<Vec3>& found = samples.points;
    EXPECT_EQ(found.size() - samples.inside_of.size(), 4u + 6u + 4u);
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

TEST(DeviationSamples, LieInsideOfLargeTriangles) {
    const TriangleMesh mesh = samples::tetrahedron();
    const DeviationSamples samples = deviation_samples(mesh);
    EXPECT_GE(samples.points.size(), 1000u);
    EXPECT_LE(samples.inside_of.size(), 4000u);
    const std::size_t first = samples.points.size() - samples.inside_of.size();
    std::vector<int> in_triangle(mesh.triangles.size(), 0);
    for (std::size_t i = 0; i < samples.inside_of.size(); ++i) {
        const Triangle& t = mesh.triangles[samples.inside_of[i]];
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3& b = mesh.vertices[t[1]];
        const Vec3& c = mesh.vertices[t[2]];
        const Vec3& p = samples.points[first + i];
        const double whole = (b - a).cross(c - a).norm();
        const double parts = (b - a).cross(p - a).norm() + (c - b).cross(p - b).norm() + (a - c).cross(p - c).norm();
        EXPECT_NEAR(parts, whole, 1e-12);
        ++in_triangle[samples.inside_of[i]];
    }
    EXPECT_GE(*std::min_element(in_triangle.begin(), in_triangle.end()), 100);
    std::vector<double> values(samples.points.size(), 0.0);
    values.back() = 5.0;
    EXPECT_EQ(samples.largest(values)[samples.inside_of.back()], 5.0);
}

TEST(DeviationSamples, AreFewInsideOfNeedles) {
    // Triangles of the mesh, all of them needles.
    constexpr int kNeedles = 1000;
    TriangleMesh strip;
    for (int i = 0; i <= kNeedles + 1; ++i) {
        strip.vertices.push_back(Vec3(0.001 * i, i % 2 == 0 ? 0.0 : 50.0, 0.0));
    }
    for (int i = 0; i < kNeedles; ++i) {
        strip.triangles.push_back({i, i + 1, i + 2});
    }
    EXPECT_LE(deviation_samples(strip).inside_of.size(), 4000u);
}

}  // namespace
}  // namespace mq::mesh

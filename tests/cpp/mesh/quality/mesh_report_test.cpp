// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/mesh_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "mesh/quality/exemptions.h"
#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

using samples::tetrahedron;
using samples::torus;

TEST(Report, TetrahedronIsCleanAndMeasuredRight) {
    const MeshReport r = measure(tetrahedron());
    EXPECT_EQ(r.triangles, 4u);
    EXPECT_EQ(r.vertices, 4u);
    EXPECT_TRUE(r.closed && r.oriented && r.manifold);
    EXPECT_EQ(r.components, 1u);
    EXPECT_EQ(r.euler, 2);
    EXPECT_NEAR(r.min_angle, 45.0, 1e-12);
    EXPECT_NEAR(r.max_angle, 90.0, 1e-12);
    EXPECT_NEAR(r.mean_min_angle, (3 * 45.0 + 60.0) / 4.0, 1e-12);
    EXPECT_NEAR(r.max_aspect, std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(r.volume, 1.0 / 6.0, 1e-15);
    EXPECT_NEAR(r.area, 1.5 + std::sqrt(3.0) / 2.0, 1e-12);
    EXPECT_EQ(r.box.high, Vec3(1, 1, 1));
    EXPECT_EQ(r.max_chord_height, -1.0);
}

TEST(Report, StretchingAndDegreeAreThoseOfTheWorstNeighbours) {
    MeshReport r = measure(tetrahedron());
    EXPECT_NEAR(r.max_stretching, 1.0, 1e-12);  // all four have an edge of length sqrt(2) as their longest
    EXPECT_EQ(r.max_degree, 3u);

    TriangleMesh fan;  // around the origin, its rim at distance 1 but for one vertex at 3
    fan.vertices.push_back(Vec3::Zero());
    for (int k = 0; k < 6; ++k) {
        fan.vertices.push_back((k == 2 ? 3.0 : 1.0) * Vec3(std::cos(k * M_PI / 3.0), std::sin(k * M_PI / 3.0), 0.0));
        fan.triangles.push_back({0, k + 1, (k + 1) % 6 + 1});
    }
    r = measure(fan);
    EXPECT_NEAR(r.max_stretching, 3.0, 1e-12);
    EXPECT_EQ(r.max_degree, 6u);

    fan.triangles.resize(1);
    r = measure(fan);
    EXPECT_EQ(r.max_stretching, 0.0);
    EXPECT_EQ(r.max_degree, 2u);
}

TEST(Report, TorusHasEulerNumberZeroAndVolumeOfEitherSign) {
    TriangleMesh mesh = torus(200);
    MeshReport r = measure(mesh);
    EXPECT_TRUE(r.closed && r.oriented && r.manifold);
    EXPECT_EQ(r.euler, 0);
    EXPECT_EQ(r.components, 1u);
    EXPECT_NEAR(r.volume, 2.0 * M_PI * M_PI * 3.0, 0.05);
    EXPECT_EQ(std::accumulate(r.angle_histogram.begin(), r.angle_histogram.end(), std::size_t{0}), r.triangles);
    for (Triangle& t : mesh.triangles) {
        std::swap(t[1], t[2]);
    }
    r = measure(mesh);
    EXPECT_TRUE(r.oriented);
    EXPECT_LT(r.volume, 0.0);
}

TEST(Report, OriginMovesTheBoxOnly) {
    TriangleMesh mesh = torus(20);
    const MeshReport here = measure(mesh);
    mesh.origin = Vec3(1e6, 0, 0);
    const MeshReport there = measure(mesh);
    EXPECT_EQ(here.volume, there.volume);
    EXPECT_EQ(here.min_angle, there.min_angle);
    EXPECT_EQ(there.box.low.x(), here.box.low.x() + 1e6);
}

TEST(Report, HoleAndFlippedTriangleAreCounted) {
    TriangleMesh mesh = torus(20);
    mesh.triangles.pop_back();
    mesh.triangle_face.pop_back();
    MeshReport r = measure(mesh);
    EXPECT_FALSE(r.closed);
    EXPECT_TRUE(r.oriented && r.manifold);
    EXPECT_EQ(r.border_edges, 3u);
    EXPECT_EQ(r.volume, 0.0);

    mesh = torus(20);
    std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
    r = measure(mesh);
    EXPECT_TRUE(r.closed && r.manifold);
    EXPECT_FALSE(r.oriented);
    EXPECT_EQ(r.misoriented_edges, 3u);
}

TEST(Report, TwoBodiesThatTouchInAVertexArePinched) {
    TriangleMesh mesh = tetrahedron();
    mesh.vertices.insert(mesh.vertices.end(), {Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)});
    mesh.triangles.insert(mesh.triangles.end(), {{0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}});
    mesh.triangle_face.clear();
    mesh.vertex_entity.clear();
    const MeshReport r = measure(mesh);
    EXPECT_TRUE(r.closed && r.oriented);
    EXPECT_FALSE(r.manifold);
    EXPECT_EQ(r.pinched_vertices, 1u);
    EXPECT_EQ(r.components, 2u);
    EXPECT_EQ(r.nonmanifold_edges, 0u);
}

TEST(Report, ThreeTrianglesAtAnEdge) {
    TriangleMesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, -1, 0)};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    const MeshReport r = measure(mesh);
    EXPECT_EQ(r.nonmanifold_edges, 1u);
    EXPECT_EQ(r.border_edges, 6u);
    EXPECT_FALSE(r.manifold);
    EXPECT_FALSE(r.oriented);
}

TEST(Report, DuplicatesAreCountedOnceEachWhateverTheirOrientation) {
    TriangleMesh mesh = tetrahedron();
    mesh.triangles.push_back({2, 1, 0});
    mesh.triangles.push_back({0, 1, 2});
    mesh.triangle_face.clear();
    EXPECT_EQ(measure(mesh).duplicate_triangles, 2u);
}

TEST(Report, DegenerateTriangles) {
    TriangleMesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, 3), Vec3(0, 0, 0), Vec3(0, 1, 0)};
    mesh.triangles = {{0, 1, 2}, {0, 0, 1}, {0, 3, 4}};
    const MeshReport r = measure(mesh);
    EXPECT_EQ(r.degenerate_triangles, 3u);
    EXPECT_EQ(r.min_angle, 0.0);
    EXPECT_EQ(r.max_angle, 180.0);
    EXPECT_FALSE(r.manifold);
}

TEST(Report, SliverIsNotDegenerateAndItsAngleIsRight) {
    TriangleMesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1e-12, 0)};
    mesh.triangles = {{0, 1, 2}};
    const MeshReport r = measure(mesh);
    EXPECT_EQ(r.degenerate_triangles, 0u);
    EXPECT_NEAR(r.min_angle / (2e-12 * 180.0 / M_PI), 1.0, 1e-9);
}

TEST(Report, EmptyMeshIsNotClosed) {
    const MeshReport r = measure(TriangleMesh{});
    EXPECT_EQ(r.triangles, 0u);
    EXPECT_FALSE(r.closed);
    EXPECT_EQ(r.min_angle, 0.0);
    EXPECT_TRUE(r.box.empty());
    EXPECT_FALSE(to_text(r).empty());
}

TEST(Report, FaultyInputIsNamed) {
    TriangleMesh mesh = tetrahedron();
    mesh.triangles[2][1] = 9;
    try {
        measure(mesh);
        FAIL() << "an index out of range was accepted";
    } catch (const InvalidInput& e) {
        EXPECT_NE(std::string(e.what()).find("triangle 2 names vertex 9"), std::string::npos) << e.what();
    }
    mesh = tetrahedron();
    mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(measure(mesh), InvalidInput);
    mesh = tetrahedron();
    mesh.triangle_face.pop_back();
    EXPECT_THROW(measure(mesh), InvalidInput);
}

TEST(Report, TextSaysToWhichFaceADistanceIs) {
    MeshReport r = measure(tetrahedron());
    r.max_chord_height = 6.03;
    EXPECT_NE(
        to_text(r).find("6.03 mm: largest deviation of a triangle from its own CAD face; no bound was requested\n"),
        std::string::npos)
        << to_text(r);
    r.chord_height_asked = 7.0;
    EXPECT_NE(to_text(r).find("its own CAD face; requested at most 7 mm\n"), std::string::npos) << to_text(r);
    r.to_nearest_face = true;
    r.chord_height_asked = 0.0;
    EXPECT_NE(to_text(r).find("6.03 mm: largest distance from the nearest CAD face\n"), std::string::npos)
        << to_text(r);
}

TEST(Report, TextNamesWhatMatters) {
    MeshReport r = measure(tetrahedron());
    r.min_angle_asked = 25.0;
    r.exempt = {{2, {ExemptCause::Apex, -1.0, {}, {0, {0, 2}}}}};
    r.max_chord_height = 0.01;
    r.chord_height_asked = 0.02;
    r.notes = {Message::value("Face7 is missing")};
    const std::string text = to_text(r);
    for (const char* word : {"closed", "yes", "Vertex3", "0.01 mm", "0.02 mm", "Face7 is missing", "volume"}) {
        EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
    }
}

TEST(Report, MeanThicknessIsTwiceTheVolumeByTheArea) {
    const MeshReport r = measure(torus(20));
    EXPECT_NEAR(mean_thickness(torus(20)), 2.0 * r.volume / r.area, 1e-12);
    EXPECT_EQ(mean_thickness(TriangleMesh()), 0.0);
}

TEST(Report, OneLineSaysWhatTheMeshIs) {
    MeshReport r = measure(tetrahedron());
    EXPECT_EQ(in_short(r).rfind("4 triangles, closed, smallest angle ", 0), 0u) << in_short(r);
    EXPECT_EQ(in_short(MeshReport{}), "no triangles");
    EXPECT_EQ(counted(1, "open edge"), "1 open edge");
    EXPECT_EQ(counted(1234567, "triangle"), "1,234,567 triangles");
}

TEST(Report, AnyFaultOrMissedLimitIsOne) {
    const MeshReport good = measure(tetrahedron());
    EXPECT_FALSE(has_faults(good));
    MeshReport r = good;
    r.min_angle_asked = r.min_angle + 1.0;
    EXPECT_TRUE(has_faults(r));
    r = good;
    r.max_chord_height = 0.02;
    EXPECT_FALSE(has_faults(r)) << "none was requested";
    r.chord_height_asked = 0.01;
    EXPECT_TRUE(has_faults(r));
    r = good;
    r.self_intersections = 1;
    EXPECT_TRUE(has_faults(r));
    r = good;
    r.missing = {{0, "no triangulation"}};
    EXPECT_TRUE(has_faults(r));
    r = good;
    r.complete = false;
    EXPECT_TRUE(has_faults(r));
}

}  // namespace
}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/improve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/quality/surface_distance.h"

namespace mq::improve {
namespace {

using mesh::TriangleMesh;

void add_quad(TriangleMesh& mesh, std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

/// A closed cylinder around z with `sides` long sides: needles all around, thin triangles at both ends.
TriangleMesh cylinder(int sides, double height) {
    TriangleMesh mesh;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * M_PI * i / sides;
        for (const double z : {0.0, height}) {
            mesh.vertices.emplace_back(float(std::cos(angle)), float(std::sin(angle)), float(z));
        }
    }
    for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        add_quad(mesh, 2 * i, 2 * j, 2 * j + 1, 2 * i + 1);
        if (i > 0 && j > 0) {
            mesh.triangles.push_back({0, 2 * j, 2 * i});
            mesh.triangles.push_back({1, 2 * i + 1, 2 * j + 1});
        }
    }
    return mesh;
}

/// An open square grid whose inner vertices are moved at random within the plane.
TriangleMesh shaken_grid(int cells, double by) {
    TriangleMesh mesh;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-by, by);
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const bool inner = i > 0 && j > 0 && i < cells && j < cells;
            mesh.vertices.emplace_back(float(i + (inner ? shift(random) : 0.0)),
                                       float(j + (inner ? shift(random) : 0.0)), 0.0);
        }
    }
    const auto at = [&](int i, int j) { return j * (cells + 1) + i; };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            add_quad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return mesh;
}

/// Checks what improve promises of every result.
Result checked(const TriangleMesh& given, const ImproveOptions& options, double tolerance) {
    const Result result = improve(given, options);
    const mesh::MeshReport before = mesh::measure(given), after = mesh::measure(result.mesh);
    EXPECT_EQ(after.closed, before.closed);
    EXPECT_EQ(after.oriented, before.oriented);
    EXPECT_EQ(after.euler, before.euler);
    EXPECT_EQ(after.components, before.components);
    EXPECT_GE(after.manifold, before.manifold);
    EXPECT_TRUE(mesh::self_intersections(result.mesh.vertices, result.mesh.triangles).empty());
    EXPECT_LE(mesh::surface_distance(result.mesh, given, Progress()).largest, tolerance * 1.001);
    for (const Vec3& p : result.mesh.vertices) {
        EXPECT_EQ(p, Vec3(p.cast<float>().cast<double>()));
    }
    std::size_t below = 0;
    for (std::size_t bin = 0; bin < std::size_t(options.min_angle); ++bin) {
        below += after.angle_histogram[bin];
    }
    EXPECT_EQ(below, result.exempt.size());
    return result;
}

TEST(Improve, CylinderOfNeedlesReachesTheAngle) {
    const TriangleMesh given = cylinder(64, 5.0);
    ASSERT_LT(mesh::measure(given).min_angle, 2.0);
    const Result result = checked(given, {}, 0.005);
    EXPECT_TRUE(result.exempt.empty());
    EXPECT_GE(mesh::measure(result.mesh).min_angle, 25.0);
}

TEST(Improve, SharpEdgesStay) {
    const TriangleMesh given = cylinder(48, 3.0);
    const Result result = checked(given, {}, 0.005);
    // All vertices at an end's border are on the circle's chords, and both ends are flat.
    double rim = 0.0;
    for (const Vec3& p : result.mesh.vertices) {
        EXPECT_GE(p.z(), 0.0);
        EXPECT_LE(p.z(), 3.0);
        rim += p.z() == 0.0 && std::hypot(p.x(), p.y()) > 0.97 ? 1.0 : 0.0;
    }
    EXPECT_GE(rim, 40.0);
    EXPECT_NEAR(mesh::measure(result.mesh).volume, mesh::measure(given).volume, 0.01 * mesh::measure(given).volume);
}

TEST(Improve, ABorderStaysStraight) {
    const TriangleMesh given = shaken_grid(12, 0.3);
    ASSERT_LT(mesh::measure(given).min_angle, 20.0);
    ImproveOptions options;
    options.min_angle = 30.0;
    const Result result = checked(given, options, 0.012);
    EXPECT_TRUE(result.exempt.empty());
    EXPECT_NEAR(mesh::measure(result.mesh).area, 144.0, 1e-4);
    EXPECT_GT(mesh::measure(result.mesh).border_edges, 0U);
}

TEST(Improve, AGoodMeshStaysAsItIs) {
    const TriangleMesh given = shaken_grid(8, 0.0);
    const Result result = checked(given, {}, 0.008);
    EXPECT_EQ(result.mesh.triangles, given.triangles);
    EXPECT_EQ(result.flips + result.collapses + result.splits + result.moves, 0U);
}

TEST(Improve, AngleBetweenSharpEdgesIsNamed) {
    // A wedge of 5 degrees.
    TriangleMesh wedge;
    const double high = 10.0 * std::tan(5.0 * M_PI / 180.0);
    for (const double z : {0.0, 4.0}) {
        for (const Vec3& p : {Vec3(0, 0, z), Vec3(10, 0, z), Vec3(10, float(high), z)}) {
            wedge.vertices.push_back(p);
        }
    }
    wedge.triangles = {{0, 2, 1}, {3, 4, 5}};
    add_quad(wedge, 0, 1, 4, 3);
    add_quad(wedge, 1, 2, 5, 4);
    add_quad(wedge, 2, 0, 3, 5);
    const Result result = checked(wedge, {}, 0.01);
    ASSERT_FALSE(result.exempt.empty());
    EXPECT_EQ(result.exempt.front().second.cause, mesh::ExemptCause::SharpEdges);
    EXPECT_LE(result.mesh.triangles.size(), 400U);
}

TEST(Improve, SameBytesEveryTime) {
    const TriangleMesh given = cylinder(40, 4.0);
    const Result first = improve(given, {}), second = improve(given, {});
    EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
    EXPECT_EQ(first.mesh.vertices, second.mesh.vertices);
}

TEST(Improve, TheOriginStays) {
    TriangleMesh given = cylinder(20, 4.0);
    given.origin = Vec3(1e6, 0, 0);
    EXPECT_EQ(improve(given, {}).mesh.origin, given.origin);
}

TEST(Improve, BadInputIsRefused) {
    TriangleMesh given = cylinder(20, 4.0);
    ImproveOptions options;
    options.min_angle = 40.0;
    try {
        improve(given, options);
        FAIL() << "40 degrees were accepted";
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("min_angle = 40 is not allowed"), std::string::npos) << error.what();
    }
    options = {};
    options.tolerance = -1.0;
    EXPECT_THROW(improve(given, options), InvalidInput);
    EXPECT_THROW(improve(TriangleMesh(), {}), InvalidInput);
    given.triangles.push_back({1, 1, 2});
    EXPECT_THROW(improve(given, {}), InvalidInput);
}

TEST(Improve, CanBeCancelled) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(improve(cylinder(64, 5.0), {}, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::improve

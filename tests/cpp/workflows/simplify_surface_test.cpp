// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/simplify_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "base/error.h"
#include "mesh/proof/distance_bounds.h"

namespace mq::workflows {
namespace {

using mesh::TriangleMesh;

constexpr int kCells = 12;

/// The surface of the cube of side 2 around the origin, each side divided into kCells^2 squares of two triangles; the
/// sides are its faces 0 to 5.
TriangleMesh cube() {
    TriangleMesh mesh;
    std::map<std::array<int, 3>, std::int32_t> numbers;
    const auto vertex = [&](std::array<int, 3> at) {
        const auto [found, is_new] = numbers.insert({at, static_cast<std::int32_t>(mesh.vertices.size())});
        if (is_new) {
            mesh.vertices.push_back(to_single(2.0 / kCells * Vec3(at[0], at[1], at[2]) - Vec3::Ones()));
        }
        return found->second;
    };
    for (int side = 0; side < 6; ++side) {
        const auto axis = static_cast<std::size_t>(side / 2);
        const bool is_far = side % 2 == 1;
        const auto at = [&](int i, int j) {
            std::array<int, 3> place{};
            place[axis] = is_far ? kCells : 0;
            place[(axis + 1) % 3] = is_far ? i : j;
            place[(axis + 2) % 3] = is_far ? j : i;
            return vertex(place);
        };
        for (int i = 0; i < kCells; ++i) {
            for (int j = 0; j < kCells; ++j) {
                mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
                mesh.triangle_face.insert(mesh.triangle_face.end(), 2, side);
            }
        }
    }
    return mesh;
}

/// The vertices of the cube on the sphere of this radius: its triangles have no faces.
TriangleMesh sphere(double radius) {
    TriangleMesh mesh = cube();
    mesh.triangle_face.clear();
    for (Vec3& p : mesh.vertices) {
        p = to_single(radius * p.normalized());
    }
    return mesh;
}

/// The triangles of a mesh whose corners are all above a height: an open surface.
TriangleMesh above(const TriangleMesh& mesh, double height) {
    TriangleMesh part = mesh;
    part.triangles.clear();
    std::copy_if(mesh.triangles.begin(), mesh.triangles.end(), std::back_inserter(part.triangles), [&](const auto& t) {
        return std::all_of(t.begin(), t.end(), [&](std::int32_t v) { return mesh.vertices[v][2] > height; });
    });
    return part;
}

SimplifiedSurface simplified(const TriangleMesh& given, double tolerance, double feature_angle = 35.0) {
    Progress progress;
    return simplify_surface(given, {tolerance, feature_angle}, progress);
}

std::vector<mesh::Corners> corners_of(const TriangleMesh& mesh) {
    std::vector<mesh::Corners> all;
    for (const mesh::Triangle& t : mesh.triangles) {
        all.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
    }
    return all;
}

/// Bound of the distance of all points of one mesh from another one.
double distance(const TriangleMesh& one, const TriangleMesh& other, double fineness) {
    Progress progress;
    const mesh::SearchedSurface searched(other.vertices, other.triangles);
    return mesh::deviation_from_distance(corners_of(one), searched, 0.0, fineness, progress).bound;
}

TEST(SimplifySurface, ACubeTakesTwelveTrianglesWithTheirFaces) {
    const TriangleMesh given = cube();
    const SimplifiedSurface found = simplified(given, 0.01);
    EXPECT_EQ(found.surface.report.triangles, 12U);
    EXPECT_TRUE(found.surface.report.closed);
    EXPECT_NEAR(found.surface.report.volume, 8.0, 1e-6);
    const std::set<std::int32_t> faces(found.surface.mesh.triangle_face.begin(),
                                       found.surface.mesh.triangle_face.end());
    EXPECT_EQ(faces, (std::set<std::int32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_LE(found.deviation, 0.01);
}

TEST(SimplifySurface, DistancesOfASphereAreWithinTheToleranceBothWays) {
    const TriangleMesh given = sphere(1.0);
    for (const double tolerance : {0.05, 0.01, 0.003}) {
        const SimplifiedSurface found = simplified(given, tolerance);
        const TriangleMesh& mesh = found.surface.mesh;
        EXPECT_LT(mesh.triangles.size(), given.triangles.size());
        EXPECT_LE(found.deviation, tolerance);
        // The other bounds have a fineness of their own.
        const double fineness = 0.01 * tolerance;
        EXPECT_LE(distance(mesh, given, fineness), found.deviation + fineness);
        EXPECT_LE(distance(given, mesh, fineness), found.deviation + fineness);
        EXPECT_TRUE(found.surface.report.closed && found.surface.report.oriented && found.surface.report.manifold);
        EXPECT_EQ(found.surface.report.self_intersections, 0);
    }
}

TEST(SimplifySurface, WherePointsAreTooFarTheyAreKeptNearAndNothingAroundThemIsFixed) {
    // Fixing left 790 and 142.
    EXPECT_LE(simplified(sphere(10.0), 0.1).surface.mesh.triangles.size(), 560U);
    EXPECT_LE(simplified(sphere(10.0), 0.5).surface.mesh.triangles.size(), 115U);
}

TEST(SimplifySurface, FewerTrianglesWithALargerTolerance) {
    const TriangleMesh given = sphere(10.0);
    std::size_t before = given.triangles.size() + 1;
    for (const double tolerance : {0.02, 0.1, 0.5}) {
        const std::size_t now = simplified(given, tolerance).surface.mesh.triangles.size();
        EXPECT_LT(now, before);
        before = now;
    }
}

TEST(SimplifySurface, TrianglesAtAnOpenBorderStay) {
    const TriangleMesh given = above(sphere(1.0), 0.2);
    const SimplifiedSurface found = simplified(given, 0.03);
    EXPECT_LT(found.surface.mesh.triangles.size(), given.triangles.size());
    EXPECT_FALSE(found.surface.report.closed);
    EXPECT_EQ(found.surface.report.border_edges, mesh::measure(given).border_edges);
}

TEST(SimplifySurface, TheResultIsTheSameEveryTime) {
    const TriangleMesh given = sphere(3.0);
    const TriangleMesh first = simplified(given, 0.05).surface.mesh;
    const TriangleMesh second = simplified(given, 0.05).surface.mesh;
    EXPECT_EQ(first.triangles, second.triangles);
    ASSERT_EQ(first.vertices.size(), second.vertices.size());
    for (std::size_t v = 0; v < first.vertices.size(); ++v) {
        EXPECT_EQ(first.vertices[v], second.vertices[v]);
    }
}

TEST(SimplifySurface, VerticesInOnePlaceAreOne) {
    TriangleMesh torn = cube();
    torn.triangle_face.clear();
    std::vector<Vec3> apart;
    for (mesh::Triangle& t : torn.triangles) {
        for (std::int32_t& v : t) {
            apart.push_back(torn.vertices[v]);
            v = static_cast<std::int32_t>(apart.size()) - 1;
        }
    }
    torn.vertices = apart;
    const SimplifiedSurface found = simplified(torn, 0.01);
    EXPECT_EQ(found.surface.report.triangles, 12U);
    EXPECT_TRUE(found.surface.report.closed);
}

TEST(SimplifySurface, AMeshThatIsNotManifoldIsRefused) {
    TriangleMesh book;
    book.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, -1, 0)};
    book.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    EXPECT_THROW(simplified(book, 0.1), InvalidInput);
}

TEST(SimplifySurface, AMeshWhoseNeighboursDisagreeOnOutsideIsRefused) {
    TriangleMesh turned = cube();
    std::swap(turned.triangles[5][0], turned.triangles[5][1]);
    EXPECT_THROW(simplified(turned, 0.1), InvalidInput);
}

TEST(SimplifySurface, IsCancelled) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(simplify_surface(sphere(1.0), {0.01, 35.0}, progress), Cancelled);
}

}  // namespace
}  // namespace mq::workflows

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/proof/distance_bounds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boolean/closed_solids.h"

namespace mq::mesh {

namespace solids = boolean::solids;
namespace {

const Progress kUnwatched;

TEST(DistanceBounds, AFlatTriangleAboveAFaceIsAtItsDistance) {
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    const std::vector<Corners> above{{Vec3(1, 1, 12), Vec3(9, 1, 12), Vec3(1, 9, 12)}};
    EXPECT_NEAR(deviation_from_distance(above, surface, 2.0, 1e-5, kUnwatched).bound, 0.0, 1e-4);
    EXPECT_NEAR(deviation_from_distance(above, surface, 1.5, 1e-5, kUnwatched).bound, 0.5, 1e-4);
    EXPECT_NEAR(deviation_from_distance(above, surface, 2.75, 1e-5, kUnwatched).bound, 0.75, 1e-4);
}

TEST(DistanceBounds, ANearMissAmidATriangleIsFound) {
    // The corners are far from the box; the triangle's inside passes a corner of it at 0.5.
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    const std::vector<Corners> triangle{{Vec3(-30, -30, 10.5), Vec3(60, -30, 10.5), Vec3(5, 70, 10.5)}};
    const ProvenBound bound = deviation_from_distance(triangle, surface, 40.0, 1e-3, kUnwatched);
    EXPECT_GE(bound.bound, 39.5 - 1e-9);
}

TEST(DistanceBounds, PointsBehindTheSurfaceAndInThinGapsAreNoPartOfTheOffset) {
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const TriangleMesh far = solids::box(Vec3(100, 0, 0), Vec3(110, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    const SearchedSurface result(far.vertices, far.triangles);
    const std::vector<Corners> inside{{Vec3(4, 4, 8), Vec3(6, 4, 8), Vec3(4, 6, 8)}};
    EXPECT_EQ(distance_of_outer_points(inside, surface, 1.9, 0.1, result, 0.01, kUnwatched).bound, 0.0);
    const std::vector<Corners> outside{{Vec3(4, 4, 12), Vec3(6, 4, 12), Vec3(4, 6, 12)}};
    EXPECT_GT(distance_of_outer_points(outside, surface, 1.9, 0.1, result, 0.01, kUnwatched).bound, 90.0);
    // A result without triangles lacks all of it.
    const TriangleMesh none;
    const SearchedSurface nothing(none.vertices, none.triangles);
    EXPECT_TRUE(std::isinf(distance_of_outer_points(outside, surface, 1.9, 0.1, nothing, 0.01, kUnwatched).bound));
    EXPECT_EQ(distance_of_outer_points(inside, surface, 1.9, 0.1, nothing, 0.01, kUnwatched).bound, 0.0);
    // A lid 4.1 above the box: what is moved on from 2 by 0.2 comes nearer to the lid.
    TriangleMesh with_lid = box;
    const TriangleMesh lid = solids::box(Vec3(-20, -20, 14.1), Vec3(30, 30, 20));
    for (const Triangle& t : lid.triangles) {
        with_lid.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    }
    with_lid.vertices.insert(with_lid.vertices.end(), lid.vertices.begin(), lid.vertices.end());
    const SearchedSurface both(with_lid.vertices, with_lid.triangles);
    EXPECT_EQ(distance_of_outer_points(outside, both, 1.95, 0.2, result, 0.01, kUnwatched).bound, 0.0);
    EXPECT_GT(distance_of_outer_points(outside, both, 1.95, 0.01, result, 0.01, kUnwatched).bound, 90.0);
}

TEST(DistanceBounds, AllNearerIsAProof) {
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    EXPECT_TRUE(all_nearer({Vec3(1, 1, 11), Vec3(9, 1, 11), Vec3(1, 9, 11)}, surface, 1.2));
    EXPECT_FALSE(all_nearer({Vec3(1, 1, 11), Vec3(9, 1, 11), Vec3(1, 9, 11)}, surface, 0.99));
    EXPECT_FALSE(all_nearer({Vec3(1, 1, 11), Vec3(9, 1, 11), Vec3(1, 40, 11)}, surface, 2.0));
}

TEST(DistanceBounds, ATriangleThatCrossesTheSurfaceIsAtNoDistance) {
    // Its corners and edges are far from the edges and corners of the face that it goes through.
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    const std::vector<Corners> through{{Vec3(6, 2, 8), Vec3(6.5, 2, 13), Vec3(7, 3, 13)}};
    EXPECT_NEAR(deviation_from_distance(through, surface, 2.0, 1e-3, kUnwatched).bound, 2.0, 1e-9);
}

/// Whether a point is inside of the box of the tests below.
bool is_in_box(const Vec3& p) {
    return (p.array() > 0.0).all() && (p.array() < 10.0).all();
}

TEST(DistanceBounds, OnlyWhatIsOutsideCounts) {
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    const auto bound = [&](const Corners& t) {
        Progress progress;
        return distance_of_points_outside({t}, surface, is_in_box, 0.01, progress).bound;
    };
    // Deep inside, across a side near it, and through the box with both ends outside.
    EXPECT_EQ(bound({Vec3(3, 3, 3), Vec3(7, 3, 4), Vec3(4, 7, 6)}), 0.01);
    EXPECT_NEAR(bound({Vec3(3, 3, 3), Vec3(7, 3, 10.5), Vec3(4, 7, 6)}), 0.5, 0.011);
    EXPECT_NEAR(bound({Vec3(-2, 5, 5), Vec3(13, 5, 5), Vec3(5, 6, 5)}), 3.0, 0.011);
    // Two corners outside, and the middle of the edge between them in the surface.
    EXPECT_NEAR(bound({Vec3(-5, 5, 5), Vec3(5, -5, 5), Vec3(5, 5, 5)}), 5.0, 0.011);
    // Beside the origin of the coordinates nothing is known to be inside before it is looked at.
    EXPECT_NEAR(bound({Vec3(-0.1, -0.1, -0.1), Vec3(-0.2, -0.1, -0.1), Vec3(-0.1, -0.2, -0.1)}), std::sqrt(0.06),
                0.011);
}

/// A square of side 10 of squares of two triangles each.
TriangleMesh tiles(int along) {
    TriangleMesh mesh;
    for (int i = 0; i <= along; ++i) {
        for (int j = 0; j <= along; ++j) {
            mesh.vertices.emplace_back(10.0 * i / along, 10.0 * j / along, 0.0);
        }
    }
    for (int i = 0; i < along; ++i) {
        for (int j = 0; j < along; ++j) {
            const int v = i * (along + 1) + j;
            mesh.triangles.push_back({v, v + along + 1, v + along + 2});
            mesh.triangles.push_back({v, v + along + 2, v + 1});
        }
    }
    return mesh;
}

TEST(DistanceBounds, OverManySmallTrianglesTheBoundIsThatOfTheHeight) {
    const TriangleMesh mesh = tiles(7);
    const SearchedSurface surface(mesh.vertices, mesh.triangles);
    const std::vector<Corners> above{{Vec3(0.3, 0.2, 1.0), Vec3(9.4, 0.7, 1.0), Vec3(4.1, 9.6, 0.5)}};
    constexpr double kFineness = 0.5;
    EXPECT_NEAR(deviation_from_distance(above, surface, 0.0, kFineness, kUnwatched).bound, 1.0, 1e-9);
    EXPECT_TRUE(triangles_beyond(above, surface, 0.0, 1.0 + 1e-9, kFineness, kUnwatched).empty());
    std::vector<Vec3> places;
    EXPECT_EQ(triangles_beyond(above, surface, 0.0, 0.8, 0.01, kUnwatched, nullptr, &places).size(), 1U);
    ASSERT_EQ(places.size(), 1U);
    EXPECT_GE(places[0].z(), 0.79);
}

TEST(DistanceBounds, WitnessesProveByThemselvesThatATriangleIsNear) {
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    const std::vector<Corners> triangles{{Vec3(1, 1, 10.5), Vec3(9, 1, 10.5), Vec3(1, 9, 10.5)},
                                         {Vec3(8, 1, 10.5), Vec3(10.5, 1, 8), Vec3(8, 9, 10.5)},
                                         {Vec3(1, 1, 10.5), Vec3(9, 1, 12.5), Vec3(1, 9, 10.5)}};
    std::vector<std::vector<std::int32_t>> witnesses;
    const std::vector<std::int32_t> beyond =
        triangles_beyond(triangles, surface, 0.0, 1.0, 0.01, kUnwatched, &witnesses);
    EXPECT_EQ(beyond, std::vector<std::int32_t>{2});
    for (const std::size_t k : {0U, 1U}) {
        std::vector<Triangle> some;
        for (const std::int32_t t : witnesses[k]) {
            some.push_back(box.triangles[static_cast<std::size_t>(t)]);
        }
        const SearchedSurface alone(box.vertices, some);
        EXPECT_TRUE(triangles_beyond({triangles[k]}, alone, 0.0, 1.0, 0.01, kUnwatched).empty());
    }
    const TriangleMesh none;
    EXPECT_EQ(triangles_beyond(triangles, SearchedSurface(none.vertices, none.triangles), 0.0, 1.0, 0.01, kUnwatched),
              (std::vector<std::int32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace mq::mesh

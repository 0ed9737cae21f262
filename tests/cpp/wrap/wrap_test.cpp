// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/wrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "base/error.h"
#include "mesh/intersection/self_intersection.h"
#include "wrap/boxes.h"

namespace mq::wrap {
namespace {

using test::add_box;
using test::volume;

WrapOptions options_of(double gap, double spacing) {
    WrapOptions options;
    options.gap = gap;
    options.spacing = spacing;
    return options;
}

/// The wrap, which must be closed, 2-manifold and free of self-intersections.
WrapResult sound_wrap(const mesh::TriangleMesh& mesh, const WrapOptions& options) {
    Progress progress;
    WrapResult result = wrap(mesh, options, progress);
    std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
    for (const mesh::Triangle& t : result.mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{t[k], t[(k + 1) % 3]}];
        }
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
    EXPECT_TRUE(mesh::self_intersections(result.mesh.vertices, result.mesh.triangles).empty());
    EXPECT_EQ(result.triangle_source.size(), result.mesh.triangles.size());
    return result;
}

TEST(Wrap, BoxWithinAFractionOfTheSpacing) {
    mesh::TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {10, 7, 5});
    const WrapResult result = sound_wrap(mesh, options_of(1.0, 0.25));
    EXPECT_NEAR(volume(result.mesh), 350.0, 0.35);
    EXPECT_LT(result.distance.to_input, 0.25);
    EXPECT_LT(result.distance.from_input, 0.25);
    EXPECT_EQ(result.sheet_nodes, 0U);
}

TEST(Wrap, OrientationAndDuplicatesDoNotMatter) {
    mesh::TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {4, 4, 4});
    add_box(mesh, {2, 2, 2}, {6, 6, 6});
    const double expected = volume(sound_wrap(mesh, options_of(1.0, 0.25)).mesh);
    EXPECT_NEAR(expected, 120.0, 0.5);
    for (std::size_t k = 0; k < mesh.triangles.size(); k += 3) {
        std::swap(mesh.triangles[k][0], mesh.triangles[k][1]);
    }
    mesh.triangles.push_back(mesh.triangles[4]);
    EXPECT_NEAR(volume(sound_wrap(mesh, options_of(1.0, 0.25)).mesh), expected, 1e-9);
}

TEST(Wrap, GapsBetweenBodiesAreMarked) {
    mesh::TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {4, 4, 4});
    add_box(mesh, {4.4, 0, 0}, {8, 4, 4});
    const WrapResult result = sound_wrap(mesh, options_of(1.0, 0.25));
    EXPECT_NEAR(volume(result.mesh), 128.0, 2.0);
    int gaps = 0;
    for (const std::int32_t source : result.triangle_source) {
        gaps += source < 0 ? 1 : 0;
    }
    EXPECT_GT(gaps, 0);
}

TEST(Wrap, ThinWallsKeepTheirThicknessAndSheetsGetOne) {
    mesh::TriangleMesh wall;
    add_box(wall, {0, 0, 0}, {8, 8, 0.12});
    EXPECT_NEAR(volume(sound_wrap(wall, options_of(1.0, 0.25)).mesh), 7.68, 3.0);
    mesh::TriangleMesh sheet;
    sheet.vertices = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    const WrapResult result = sound_wrap(sheet, options_of(1.0, 0.25));
    EXPECT_NEAR(volume(result.mesh), 64.0 * 0.25, 3.0);
    EXPECT_GT(result.sheet_nodes, 0U);
    EXPECT_LE(result.distance.to_input, 0.25);
}

TEST(Wrap, LeakLeadsThroughTheOpening) {
    mesh::TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {8, 8, 8}, 1);
    add_box(mesh, {0, 0, 8}, {8, 5, 9});
    WrapOptions options = options_of(1.0, 0.25);
    options.dry = {{4, 4, 4}, {4, 2, 8.5}};
    const WrapResult result = sound_wrap(mesh, options);
    ASSERT_EQ(result.leaks.size(), 1U);
    const Leak& leak = result.leaks.front();
    EXPECT_NEAR(leak.width, 3.0, 0.5);
    EXPECT_NEAR(leak.narrowest.y(), 6.5, 0.5);
    double length = 0.0;
    for (std::size_t k = 1; k < leak.path.size(); ++k) {
        length += (leak.path[k] - leak.path[k - 1]).norm();
    }
    // Straight to the opening and out; edges of the lattice are up to a seventh longer.
    EXPECT_LT(length, 1.3 * (std::hypot(2.5, 4.0) + 1.5));
    EXPECT_NEAR((leak.path.front() - Vec3(4, 4, 4)).norm(), 0.0, 1e-12);
    const Box box{Vec3(0, 0, 0), Vec3(8, 8, 9)};
    EXPECT_FALSE(box.contains(leak.path.back()));
}

TEST(Wrap, RandomSoupsGiveSoundSurfaces) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(0.0, 6.0);
        std::uniform_real_distribution<double> edge(-1.5, 1.5);
        mesh::TriangleMesh mesh;
        for (std::int32_t k = 0; k < 25; ++k) {
            const Vec3 p(place(random), place(random), place(random));
            for (int i = 0; i < 3; ++i) {
                mesh.vertices.push_back(to_single(p + Vec3(edge(random), edge(random), edge(random))));
            }
            mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
        }
        EXPECT_GT(volume(sound_wrap(mesh, options_of(0.8, 0.3)).mesh), 0.0);
    }
}

TEST(Wrap, NoPointOfItIsFartherThanItSays) {
    mesh::TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {6, 5, 4});
    add_box(mesh, {2.03, 2.01, 3.3}, {3.37, 3.29, 4.7});
    add_box(mesh, {5.61, 1.07, 0.9}, {6.53, 3.41, 2.2});
    const WrapResult result = sound_wrap(mesh, options_of(1.0, 0.25));
    const InputSurface input(mesh.vertices, mesh.triangles);
    constexpr int kParts = 12;
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        const auto corner = [&](std::size_t k) { return result.mesh.vertices[result.mesh.triangles[t][k]]; };
        for (int i = 0; i <= kParts && result.triangle_source[t] >= 0; ++i) {
            for (int j = 0; i + j <= kParts; ++j) {
                const Vec3 p = corner(0) + (corner(1) - corner(0)) * (double(i) / kParts) +
                               (corner(2) - corner(0)) * (double(j) / kParts);
                EXPECT_LE(input.tree.nearest(p).distance, result.distance.to_input + 1e-12);
            }
        }
    }
}

TEST(Wrap, BadOptionsAreNamed) {
    mesh::TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {1, 1, 1});
    Progress progress;
    EXPECT_THROW(wrap(mesh, options_of(0.0, 0.1), progress), InvalidInput);
    EXPECT_THROW(wrap(mesh, options_of(0.1, 0.1), progress), InvalidInput);
    EXPECT_THROW(wrap(mesh, options_of(1e-4, 1e-5), progress), InvalidInput);
    EXPECT_THROW(wrap(mesh::TriangleMesh(), options_of(1.0, 0.1), progress), InvalidInput);
    mesh::TriangleMesh wire;
    wire.vertices = {{0, 0, 0}, {2e5, 0, 0}, {2e5, 0.01, 0}};
    wire.triangles = {{0, 1, 2}};
    EXPECT_THROW(wrap(wire, options_of(0.6, 0.3), progress), InvalidInput);
    progress.cancel();
    EXPECT_THROW(wrap(mesh, options_of(0.1, 0.02), progress), Cancelled);
}

}  // namespace
}  // namespace mq::wrap

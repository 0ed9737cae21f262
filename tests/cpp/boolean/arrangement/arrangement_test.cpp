// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/arrangement.h"

#include <gtest/gtest.h>

#include <map>

#include "boolean/soups.h"

namespace mq::boolean {
namespace {

using soups::Arranged;

/// By triangle of the soup the area of its pieces. A piece on which several triangles lie counts for each of them.
std::map<std::int32_t, double> areas_of_pieces(const Arranged& c) {
    std::map<std::int32_t, double> sums;
    for (const Face& face : c.arrangement->faces) {
        if (face.stack < 0) {
            sums[face.source] += soups::area(*c.arrangement, face);
            continue;
        }
        for (const CoplanarCover& cover : c.arrangement->stacks[static_cast<std::size_t>(face.stack)]) {
            sums[cover.triangle] += soups::area(*c.arrangement, face);
        }
    }
    return sums;
}

void expect_pieces_cover_their_triangles(const Arranged& c) {
    const std::map<std::int32_t, double> areas = areas_of_pieces(c);
    for (std::size_t t = 0; t < c.soup.triangles.size(); ++t) {
        const Triangle& corners = c.soup.triangles[t];
        const Vec3& a = c.soup.vertices[static_cast<std::size_t>(corners[0])];
        const double whole = 0.5 * (c.soup.vertices[static_cast<std::size_t>(corners[1])] - a)
                                       .cross(c.soup.vertices[static_cast<std::size_t>(corners[2])] - a)
                                       .norm();
        const auto found = areas.find(static_cast<std::int32_t>(t));
        ASSERT_NE(found, areas.end()) << "triangle " << t << " has no piece";
        EXPECT_NEAR(found->second, whole, 1e-12 * whole) << "triangle " << t;
    }
}

TEST(Arrangement, OfSolidsApartIsTheSolidsThemselves) {
    const Arranged c({solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), solids::box(Vec3(5, 0, 0), Vec3(6, 1, 1))});
    ASSERT_EQ(c.arrangement->faces.size(), 24u);
    EXPECT_TRUE(c.arrangement->stacks.empty());
    for (const Face& face : c.arrangement->faces) {
        EXPECT_EQ(face.points, c.soup.triangles[static_cast<std::size_t>(face.source)]);
    }
}

TEST(Arrangement, PiecesCoverTheTrianglesThatTheyComeFrom) {
    for (const auto& operands : {soups::overlapping_cubes(),
                                 std::vector<mesh::TriangleMesh>{solids::sphere(Vec3(0, 0, 0), 1.0, 6, 0.1, 3),
                                                                 solids::sphere(Vec3(0.5, 0.3, 0.2), 1.0, 7, 0.1, 4)},
                                 // A cube with a smaller one on its side: parts of two planes lie in one.
                                 std::vector<mesh::TriangleMesh>{solids::box(Vec3(0, 0, 0), Vec3(2, 2, 2)),
                                                                 solids::box(Vec3(2, 0.5, 0.5), Vec3(3, 1.5, 1.5))}}) {
        const Arranged c(operands);
        EXPECT_GT(c.arrangement->faces.size(), c.soup.triangles.size());
        expect_pieces_cover_their_triangles(c);
    }
}

TEST(Arrangement, FacesMeetInWholeEdges) {
    const Arranged c(soups::overlapping_cubes());
    std::map<EdgeKey, int> uses;
    for (const Face& face : c.arrangement->faces) {
        for (int k = 0; k < 3; ++k) {
            ++uses[edge_key(face.points[static_cast<std::size_t>(k)],
                            face.points[static_cast<std::size_t>((k + 1) % 3)])];
        }
    }
    std::size_t of_four = 0;
    for (const auto& [edge, count] : uses) {
        EXPECT_TRUE(count == 2 || count == 4) << count << " faces at an edge";
        of_four += count == 4 ? 1 : 0;
    }
    EXPECT_GE(of_four, 6u);  // the curve in which the cubes cross has six sides
}

TEST(Arrangement, FacesOnBothOperandsAreOneWithBothTriangles) {
    const Arranged c({solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), solids::box(Vec3(1, 0, 0), Vec3(2, 1, 1))});
    std::size_t shared = 0;
    for (const Face& face : c.arrangement->faces) {
        if (face.stack >= 0) {
            const auto& covers = c.arrangement->stacks[static_cast<std::size_t>(face.stack)];
            std::map<std::int32_t, int> turn_of_operand;
            for (const CoplanarCover& cover : covers) {
                turn_of_operand[c.soup.source[static_cast<std::size_t>(cover.triangle)].operand] += cover.turn;
            }
            ASSERT_EQ(turn_of_operand.size(), 2u);
            EXPECT_EQ(turn_of_operand[0] + turn_of_operand[1], 0) << "they look at each other";
            ++shared;
        }
    }
    EXPECT_GE(shared, 2u);
    expect_pieces_cover_their_triangles(c);
}

TEST(Arrangement, CanBeCancelled) {
    Soup soup = soups::soup_of(soups::overlapping_cubes());
    Progress progress;
    progress.cancel();
    EXPECT_THROW(arrange(soup, {}, soups::pairs_of(soup), progress), Cancelled);
}

}  // namespace
}  // namespace mq::boolean

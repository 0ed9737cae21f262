// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/extraction/extraction.h"

#include <gtest/gtest.h>

#include <map>

#include "boolean/random_meshes.h"
#include "boolean/soups.h"

namespace mq::boolean {
namespace {

using soups::Arranged;

Extraction extracted(const Arranged& c, Operation operation) {
    return extract(c.soup, *c.arrangement, find_cells(c.soup, *c.arrangement, c.progress),
                   Expression::chain(operation, 2), c.progress);
}

double volume(const Extraction& extraction) {
    return fuzz::signed_volume(extraction.draft.vertices, extraction.draft.triangles);
}

/// Every edge has one triangle on each side.
void expect_closed_and_oriented(const ResultMesh& draft) {
    std::map<std::array<std::int32_t, 2>, int> directed;
    for (const Triangle& t : draft.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++directed[{t[k], t[(k + 1) % 3]}];
        }
    }
    for (const auto& [edge, count] : directed) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(directed.count({edge[1], edge[0]}), 1u);
    }
}

TEST(Extraction, OfOverlappingCubesHasTheVolumeOfTheOperation) {
    const Arranged c(soups::overlapping_cubes());
    const std::map<Operation, double> expected{{Operation::Union, 15.0},
                                               {Operation::Intersection, 1.0},
                                               {Operation::Difference, 7.0},
                                               {Operation::SymmetricDifference, 14.0}};
    for (const auto& [operation, wanted] : expected) {
        const Extraction extraction = extracted(c, operation);
        EXPECT_NEAR(volume(extraction), wanted, 1e-12) << name(operation);
        expect_closed_and_oriented(extraction.draft);
    }
}

TEST(Extraction, NamesTheTriangleThatEachOneComesFrom) {
    const Arranged c(soups::overlapping_cubes());
    const ResultMesh draft = extracted(c, Operation::Union).draft;
    ASSERT_EQ(draft.source.size(), draft.triangles.size());
    ASSERT_EQ(draft.from.size(), draft.triangles.size());
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        const Triangle& whole = c.soup.triangles[static_cast<std::size_t>(draft.from[t])];
        const Vec3& a = c.soup.vertices[static_cast<std::size_t>(whole[0])];
        const Vec3 normal = (c.soup.vertices[static_cast<std::size_t>(whole[1])] - a)
                                .cross(c.soup.vertices[static_cast<std::size_t>(whole[2])] - a)
                                .normalized();
        for (const std::int32_t v : draft.triangles[t]) {
            EXPECT_NEAR(normal.dot(draft.vertices[static_cast<std::size_t>(v)] - a), 0.0, 1e-12);
        }
    }
}

TEST(Extraction, KeepsVerticesOfOperandsApartFromConstructedOnes) {
    const Arranged c(soups::overlapping_cubes());
    const ResultMesh draft = extracted(c, Operation::Intersection).draft;
    ASSERT_EQ(draft.made.size(), draft.vertices.size());
    std::map<char, int> count;
    for (const char origin : draft.made) {
        ++count[origin];
    }
    EXPECT_EQ(count[kFromOperand], 2);  // the corners of the small cube at (1, 1, 1) and (2, 2, 2)
    EXPECT_GE(count[kConstructed], 6);
}

TEST(Extraction, OfSolidsApartInCommonIsEmpty) {
    const Arranged c({solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), solids::box(Vec3(5, 0, 0), Vec3(6, 1, 1))});
    EXPECT_TRUE(extracted(c, Operation::Intersection).draft.triangles.empty());
    EXPECT_EQ(extracted(c, Operation::Union).draft.triangles.size(), 24u);
}

TEST(Extraction, RegionsThatTouchInAnEdgeGetCopiesOfIt) {
    const Arranged c({solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), solids::box(Vec3(1, 1, 0), Vec3(2, 2, 1))});
    const Extraction extraction = extracted(c, Operation::Union);
    EXPECT_EQ(extraction.copies.size(), 2u);  // both ends of the common edge
    for (const auto& copies : extraction.copies) {
        EXPECT_EQ(copies.size(), 2u);
    }
    expect_closed_and_oriented(extraction.draft);
    EXPECT_NEAR(volume(extraction), 2.0, 1e-12);
}

}  // namespace
}  // namespace mq::boolean

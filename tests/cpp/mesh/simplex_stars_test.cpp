// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/simplex_stars.h"

#include <gtest/gtest.h>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {
namespace {

template <typename Simplex>
SimplexStars stars_of(const std::vector<Simplex>& simplices, std::size_t vertices) {
    SimplexStars stars(vertices);
    for (std::size_t s = simplices.size(); s-- > 0;) {
        stars.add(static_cast<int>(s), simplices[s]);
    }
    return stars;
}

using Numbers = std::vector<int>;

TEST(SimplexStars, StarsAreInAscendingOrderAlsoAfterChanges) {
    const std::vector<Triangle> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    SimplexStars stars = stars_of(fan, 5);
    EXPECT_EQ(stars[0], (Numbers{0, 1, 2, 3}));
    stars.remove(1, fan[1]);
    EXPECT_EQ(stars[0], (Numbers{0, 2, 3}));
    EXPECT_EQ(stars[2], (Numbers{0}));
    stars.add(1, fan[1]);
    EXPECT_EQ(stars[0], (Numbers{0, 1, 2, 3}));
    EXPECT_EQ(stars.of({0, 1}, fan), (Numbers{0, 3}));
    EXPECT_EQ(stars.link({0}, fan), (Numbers{1, 2, 3, 4}));
    EXPECT_EQ(stars.link({1, 0}, fan), (Numbers{2, 4}));
    EXPECT_TRUE(stars.joined(3, 0, fan));
    EXPECT_FALSE(stars.joined(1, 3, fan));
}

TEST(SimplexStars, ALinkOfAnEdgeForbidsCollapsesThatPinchASurface) {
    // A fan with a handle: 1 and 3 are joined outside of it as well.
    const std::vector<Triangle> surface{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 3, 5}};
    const SimplexStars stars = stars_of(surface, 6);
    EXPECT_TRUE(stars.link_condition(0, 2, surface));
    EXPECT_FALSE(stars.link_condition(0, 1, surface)) << "3 is joined to both, without a triangle";
}

TEST(SimplexStars, TwoTrianglesWithTheSameVerticesAtAnEdgeForbidItsCollapse) {
    const std::vector<Triangle> surface{{0, 1, 2}, {0, 2, 1}, {1, 2, 3}, {2, 0, 3}};
    EXPECT_FALSE(stars_of(surface, 4).link_condition(0, 1, surface));
}

TEST(SimplexStars, TetrahedraHaveFacesAndRingsOfEdges) {
    // Three tetrahedra around the edge 0-1, and one on a face of the ring.
    const std::vector<std::array<int, 4>> ring{{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 2}, {0, 2, 3, 5}};
    const SimplexStars stars = stars_of(ring, 6);
    EXPECT_EQ(stars.of({1, 0}, ring), (Numbers{0, 1, 2}));
    EXPECT_EQ(stars.of({0, 2, 3}, ring), (Numbers{0, 3}));
    EXPECT_EQ(stars.link({0, 1}, ring), (Numbers{2, 3, 4}));
    EXPECT_TRUE(stars.link_condition(0, 1, ring));
    EXPECT_TRUE(stars.link_condition(0, 5, ring));
    const std::vector<std::array<int, 4>> apart{{0, 1, 2, 3}, {0, 4, 5, 6}, {1, 4, 7, 8}};
    EXPECT_FALSE(stars_of(apart, 9).link_condition(0, 1, apart)) << "4 is joined to both, without a tetrahedron";
}

}  // namespace
}  // namespace mq::mesh

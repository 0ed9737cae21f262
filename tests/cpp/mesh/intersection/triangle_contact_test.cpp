// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/triangle_contact.h"

#include <gtest/gtest.h>

#include <random>

#include "base/cases.h"
#include "mesh/exact_contact.h"
#include "mesh/intersection/tied_points.h"

namespace mq::mesh {
namespace {

TEST(TriangleContact, IsThatOfTheIntersectionInRationalArithmetic) {
    TiedPoints point(1);
    std::map<std::pair<int, Contact>, int> seen;
    for (int i = 0; i < scaled_cases(40000); ++i) {
        point.set_flat(i % 4 == 0);
        std::vector<Vec3> vertices;
        for (int k = 0; k < 6; ++k) {
            vertices.push_back(point());
        }
        const int shared = point.integer(0, 3);
        Triangle p{0, 1, 2};
        Triangle q{3, 4, 5};
        for (int k = 0; k < shared; ++k) {
            q[k] = p[k];
        }
        std::rotate(q.begin(), q.begin() + point.integer(0, 2), q.end());
        if (point.integer(0, 1) == 0) {
            std::swap(p[0], p[1]);
        }
        const Contact expected = exact::contact(vertices, p, q);
        ASSERT_EQ(contact(vertices, p, q), expected) << "case " << i << " with " << shared << " shared corners";
        ASSERT_EQ(contact(vertices, q, p), expected) << "case " << i << " with " << shared << " shared corners";
        ++seen[{shared, expected}];
    }
    for (int shared = 0; shared < 4; ++shared) {
        EXPECT_GT((seen[{shared, Contact::None}]), 0);
        EXPECT_GT((seen[{shared, Contact::Crossing}]), 0);
        EXPECT_EQ((seen[{shared, Contact::Touching}] > 0), shared < 2) << shared;
    }
}

TEST(TriangleContact, CertainlyApartAreOnlyTrianglesThatHaveNoContact) {
    TiedPoints point(3);
    int decided = 0;
    int apart = 0;
    for (int i = 0; i < scaled_cases(40000); ++i) {
        point.set_flat(i % 4 == 0);
        std::vector<Vec3> vertices;
        for (int k = 0; k < 6; ++k) {
            vertices.push_back(point());
        }
        const bool expected = exact::contact(vertices, {0, 1, 2}, {3, 4, 5}) == Contact::None;
        const bool found =
            certainly_apart({vertices[0], vertices[1], vertices[2]}, {vertices[3], vertices[4], vertices[5]});
        ASSERT_TRUE(expected || !found) << "case " << i;
        apart += expected ? 1 : 0;
        decided += found ? 1 : 0;
    }
    EXPECT_GT(decided, apart / 4);
}

TEST(TriangleContact, OfRandomTrianglesToo) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    for (int i = 0; i < scaled_cases(20000); ++i) {
        std::vector<Vec3> vertices;
        for (int k = 0; k < 6; ++k) {
            vertices.emplace_back(real(random), real(random), real(random));
        }
        const Triangle q{i % 2 == 0 ? 3 : 0, 4, 5};
        ASSERT_EQ(contact(vertices, {0, 1, 2}, q), exact::contact(vertices, {0, 1, 2}, q)) << "case " << i;
    }
}

}  // namespace
}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/self_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "base/cases.h"
#include "mesh/embedded_star.h"
#include "mesh/exact_contact.h"

namespace mq::mesh {
namespace {

/// Points where exact ties are the rule: a small grid, points on its edges and faces, and neighbours of those.
class TiedPoints {
  public:
    explicit TiedPoints(std::uint64_t seed) : random_(seed) {}

    Vec3 operator()() {
        Vec3 p(integer(0, 3), integer(0, 3), integer(0, flat_ ? 0 : 3));
        if (integer(0, 3) == 0) {
            p += 0.5 * Vec3(integer(-1, 1), integer(-1, 1), flat_ ? 0 : integer(-1, 1));
        }
        if (integer(0, 19) == 0 && p.x() != 0.0) {
            p.x() = std::nextafter(p.x(), integer(0, 1) == 0 ? -10.0 : 10.0);
        }
        return p;
    }
    void set_flat(bool flat) { flat_ = flat; }
    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  private:
    std::mt19937_64 random_;
    bool flat_ = false;
};

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

std::vector<ContactPair> brute_force(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
    std::vector<ContactPair> pairs;
    for (std::int32_t a = 0; a < int(triangles.size()); ++a) {
        for (std::int32_t b = a + 1; b < int(triangles.size()); ++b) {
            const Contact how = exact::contact(vertices, triangles[a], triangles[b]);
            if (how != Contact::None) {
                pairs.push_back({a, b, how});
            }
        }
    }
    return pairs;
}

void expect_same(const std::vector<ContactPair>& found, const std::vector<ContactPair>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].a, expected[i].a);
        EXPECT_EQ(found[i].b, expected[i].b);
        EXPECT_EQ(found[i].contact, expected[i].contact);
    }
}

TEST(SelfIntersection, FindsAllPairsOfASoup) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        TiedPoints point(seed);
        point.set_flat(seed % 4 == 0);
        std::vector<Vec3> vertices;
        for (int i = 0; i < 30; ++i) {
            vertices.push_back(point());
        }
        std::vector<Triangle> triangles;
        for (int i = 0; i < 24; ++i) {
            const int a = point.integer(0, 9);
            triangles.push_back({a, point.integer(10, 19), point.integer(20, 29)});
        }
        const std::vector<ContactPair> expected = brute_force(vertices, triangles);
        expect_same(self_intersections(vertices, triangles), expected);
        const std::vector<std::int32_t> subset{1, 2, 3, 5, 8, 13, 21};
        std::vector<ContactPair> with_subset;
        for (const ContactPair& pair : expected) {
            if (std::count(subset.begin(), subset.end(), pair.a) + std::count(subset.begin(), subset.end(), pair.b)) {
                with_subset.push_back(pair);
            }
        }
        expect_same(self_intersections_with(vertices, triangles, subset), with_subset);
        EXPECT_EQ(self_intersections(vertices, triangles, 3).size(), std::min<std::size_t>(3, expected.size()));
    }
}

TEST(SelfIntersection, WithASubsetOfManySmallAndSomeLargeTriangles) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    for (const double large : {0.0, 0.02, 0.5}) {
        std::vector<Vec3> vertices;
        std::vector<Triangle> triangles;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 center(real(random), real(random), real(random));
            const double size = 0.5 + 0.5 * real(random) < large ? 1.0 : 0.1;
            for (int k = 0; k < 3; ++k) {
                vertices.emplace_back(center + size * Vec3(real(random), real(random), real(random)));
            }
            triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        std::vector<std::int32_t> subset;
        std::vector<char> in_subset(3000, 0);
        for (std::int32_t t = 0; t < 3000; ++t) {
            // Together in one part of space, so that others lie outside of it.
            if (vertices[3 * t].x() > 0.7 && t % 3 == 0) {
                subset.push_back(t);
                in_subset[t] = 1;
            }
        }
        std::vector<ContactPair> expected;
        for (const ContactPair& pair : self_intersections(vertices, triangles)) {
            if (in_subset[pair.a] + in_subset[pair.b] > 0) {
                expected.push_back(pair);
            }
        }
        EXPECT_GT(expected.size(), 10u);
        expect_same(self_intersections_with(vertices, triangles, subset), expected);
    }
}

/// A closed fan around vertex 0, its rim at `radius(k)` in direction `angle(k)` and height `height(k)`.
struct Fan {
    template <typename Rim>
    Fan(int count, const Rim& rim) {
        vertices.emplace_back(0, 0, 0);
        for (int k = 0; k < count; ++k) {
            vertices.push_back(rim(k));
            triangles.push_back({0, 1 + k, 1 + (k + 1) % count});
        }
    }
    bool embedded() const { return embedded_star(vertices, triangles, VertexStars(triangles, vertices.size())[0]); }

    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

Vec3 on_circle(double angle, double height) {
    return {std::cos(angle), std::sin(angle), height};
}

TEST(EmbeddedStar, HoldsForCornersOfSolids) {
    EXPECT_TRUE(Fan(6, [](int k) { return on_circle(2 * M_PI * k / 6, 0.0); }).embedded());
    EXPECT_TRUE(Fan(6, [](int k) { return on_circle(2 * M_PI * k / 6, -5.0); }).embedded());
    EXPECT_TRUE(Fan(5, [](int k) { return on_circle(2 * M_PI * k / 5, k % 2 == 0 ? 0.3 : -0.3); }).embedded());
    EXPECT_TRUE(Fan(3, [](int k) { return Vec3(Vec3::Unit(k)); }).embedded());
}

TEST(EmbeddedStar, DoesNotHoldWhereTheLinkTurnsTwiceOrFolds) {
    EXPECT_FALSE(Fan(10, [](int k) { return on_circle(4 * M_PI * k / 10, 0.1 * k); }).embedded());
    EXPECT_FALSE(Fan(4, [](int k) { return on_circle(k == 2 ? 0.1 : 2 * M_PI * k / 4, 0.0); }).embedded());
    Fan open(6, [](int k) { return on_circle(2 * M_PI * k / 6, 0.0); });
    open.triangles.pop_back();
    EXPECT_FALSE(open.embedded());
    Fan twice(3, [](int k) { return on_circle(2 * M_PI * k / 3, 0.0); });
    twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
    EXPECT_FALSE(twice.embedded());
}

TEST(EmbeddedStar, IsNeverMistaken) {
    TiedPoints point(7);
    int held = 0;
    for (int i = 0; i < scaled_cases(4000); ++i) {
        const int count = point.integer(3, 7);
        const double lift = point.integer(-2, 2);
        const Fan fan(count, [&](int k) -> Vec3 {
            if (i % 2 == 0) {
                return point() - Vec3(1.5, 1.5, 1.5);
            }
            return on_circle(2 * M_PI * k / count, lift) + 0.2 * point();
        });
        if (fan.embedded()) {
            ++held;
            EXPECT_TRUE(brute_force(fan.vertices, fan.triangles).empty()) << "case " << i;
        }
    }
    EXPECT_GT(held, scaled_cases(400));
}

TEST(SelfIntersections, WithinALimitNothingIsMissedWhereverThePairsAre) {
    // A large sheet without faults, and a knot of crossing triangles in one place.
    constexpr int kSide = 150;
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (int y = 0; y <= kSide; ++y) {
        for (int x = 0; x <= kSide; ++x) {
            vertices.emplace_back(x, y, 0.0);
            const auto at = [](int i, int j) { return static_cast<std::int32_t>(j * (kSide + 1) + i); };
            if (x < kSide && y < kSide) {
                triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
                triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
            }
        }
    }
    constexpr int kKnot = 30;
    for (int k = 0; k < kKnot; ++k) {
        const double angle = M_PI * k / kKnot;
        const Vec3 along(std::cos(angle), std::sin(angle), 0.0);
        const auto first = static_cast<std::int32_t>(vertices.size());
        const Vec3 center(70.5, 70.5, 5.0);
        vertices.insert(vertices.end(), {center - along, center + along, center + Vec3(0.0, 0.0, 1.0 + 0.01 * k)});
        triangles.push_back({first, first + 1, first + 2});
    }
    const std::size_t pairs = kKnot * (kKnot - 1) / 2;
    ASSERT_EQ(self_intersections(vertices, triangles).size(), pairs);
    EXPECT_EQ(self_intersections(vertices, triangles, pairs + 1).size(), pairs);
    EXPECT_EQ(self_intersections(vertices, triangles, pairs - 1).size(), pairs - 1);
}

}  // namespace
}  // namespace mq::mesh

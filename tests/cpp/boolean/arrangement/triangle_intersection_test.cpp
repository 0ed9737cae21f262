// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/triangle_intersection.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

namespace mq::boolean {
namespace {

/// Two triangles of different operands, and what they have in common.
struct Pair {
    Pair(std::vector<Vec3> vertices, const Triangle& s, const Triangle& t) {
        soup.vertices = std::move(vertices);
        soup.triangles = {s, t};
        soup.source = {{0, 0}, {1, 0}};
        soup.operands = 2;
        points = std::make_unique<PointTable>(soup);
        intersect(soup, 0, 1, *points, found);
    }
    Pair(const Pair&) = delete;
    Pair& operator=(const Pair&) = delete;

    std::size_t on_edges() const {
        std::size_t sum = 0;
        for (const auto& entry : found.on_edge) {
            sum += entry.second.size();
        }
        return sum;
    }
    std::size_t inside() const {
        std::size_t sum = 0;
        for (const auto& entry : found.in_face) {
            sum += entry.second.size();
        }
        return sum;
    }
    bool nothing() const { return on_edges() + inside() == 0 && found.segments.empty() && found.overlapping.empty(); }

    Soup soup;
    std::unique_ptr<PointTable> points;
    Incidences found;
};

const std::vector<Vec3> kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

std::vector<Vec3> flat_and(const Vec3& a, const Vec3& b, const Vec3& c) {
    std::vector<Vec3> vertices = kFlat;
    vertices.insert(vertices.end(), {a, b, c});
    return vertices;
}

TEST(TrianglePair, ApartHasNothingInCommon) {
    EXPECT_TRUE(Pair(flat_and({0, 0, 1}, {4, 0, 1}, {0, 4, 2}), {0, 1, 2}, {3, 4, 5}).nothing()) << "above";
    EXPECT_TRUE(Pair(flat_and({5, 5, -1}, {5, 5, 1}, {6, 6, 1}), {0, 1, 2}, {3, 4, 5}).nothing()) << "beside";
    EXPECT_TRUE(Pair(flat_and({5, 0, 0}, {9, 0, 0}, {5, 4, 0}), {0, 1, 2}, {3, 4, 5}).nothing()) << "in one plane";
}

TEST(TrianglePair, ThatPierceEachOtherShareASegment) {
    const Pair pair(flat_and({1, 1, -1}, {1, 1, 1}, {9, 1, 1}), {0, 1, 2}, {3, 4, 5});
    ASSERT_EQ(pair.found.segments.size(), 2u);
    for (std::int32_t own = 0; own < 2; ++own) {
        ASSERT_EQ(pair.found.segments.at(own).size(), 1u);
        const Segment& segment = pair.found.segments.at(own)[0];
        EXPECT_EQ(segment.other, 1 - own);
        std::array<Vec3, 2> ends{pair.points->approx(segment.from), pair.points->approx(segment.to)};
        if (ends[0].x() > ends[1].x()) {
            std::swap(ends[0], ends[1]);
        }
        EXPECT_EQ(ends[0], Vec3(1, 1, 0)) << "where an edge of the second pierces the first";
        EXPECT_EQ(ends[1], Vec3(3, 1, 0)) << "where the second passes the longest edge of the first";
    }
    // The first end lies inside the first triangle and on an edge of the second, the other one the other way round.
    EXPECT_EQ(pair.inside(), 2u);
    EXPECT_EQ(pair.on_edges(), 2u);
    EXPECT_EQ(pair.points->size(), 8);
}

TEST(TrianglePair, ASharedVertexAloneIsNoIncidence) {
    const Pair pair({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-1, -1, 1}, {-2, -1, 3}}, {0, 1, 2}, {0, 3, 4});
    EXPECT_TRUE(pair.nothing());
}

TEST(TrianglePair, AVertexOnTheOtherOneIsRecordedOnce) {
    const Pair inside(flat_and({1, 1, 0}, {1, 1, 3}, {2, 1, 3}), {0, 1, 2}, {3, 4, 5});
    EXPECT_EQ(inside.found.in_face.at(0), std::vector<std::int32_t>{3});
    EXPECT_EQ(inside.on_edges(), 0u);
    EXPECT_TRUE(inside.found.segments.empty()) << "they meet in a point";
    const Pair on_edge(flat_and({2, 0, 0}, {2, -1, 3}, {3, -1, 3}), {0, 1, 2}, {3, 4, 5});
    EXPECT_EQ(on_edge.found.on_edge.at(edge_key(0, 1)), std::vector<std::int32_t>{3});
    EXPECT_EQ(on_edge.inside(), 0u);
}

TEST(TrianglePair, AnEdgeThatMeetsAnEdgeDividesBoth) {
    // The edge from (2, -1, -1) to (2, 1, 1) meets the edge y = 0 of the first in its middle.
    const Pair pair(flat_and({2, -1, -1}, {2, 1, 1}, {2, -9, 9}), {0, 1, 2}, {3, 4, 5});
    ASSERT_EQ(pair.found.on_edge.count(edge_key(0, 1)), 1u);
    ASSERT_EQ(pair.found.on_edge.count(edge_key(3, 4)), 1u);
    EXPECT_EQ(pair.found.on_edge.at(edge_key(0, 1)), pair.found.on_edge.at(edge_key(3, 4))) << "one point for both";
    EXPECT_EQ(pair.points->approx(pair.found.on_edge.at(edge_key(0, 1))[0]), Vec3(2, 0, 0));
}

TEST(TrianglePair, OfOnePlaneOverlapOnlyWithTheirInsides) {
    const Pair across(flat_and({1, -1, 0}, {3, -1, 0}, {2, 9, 0}), {0, 1, 2}, {3, 4, 5});
    ASSERT_EQ(across.found.overlapping.size(), 1u);
    EXPECT_EQ(across.on_edges(), 8u) << "four crossings of edges, each on two of them";
    const Pair beside(flat_and({0, 0, 0}, {4, 0, 0}, {2, -3, 0}), {0, 1, 2}, {3, 4, 5});
    EXPECT_TRUE(beside.found.overlapping.empty()) << "they share an edge in space";
    const Pair within(flat_and({1, 1, 0}, {2, 1, 0}, {1, 2, 0}), {0, 1, 2}, {3, 4, 5});
    EXPECT_EQ(within.found.overlapping.size(), 1u);
    EXPECT_EQ(within.found.in_face.at(0).size(), 3u);
}

TEST(TrianglePair, TheOrderOfTheTwoMakesNoDifference) {
    const std::vector<Vec3> vertices = flat_and({1, 1, -1}, {1, 1, 1}, {9, 1, 1});
    const Pair one(vertices, {0, 1, 2}, {3, 4, 5});
    const Pair other(vertices, {3, 4, 5}, {0, 1, 2});
    EXPECT_EQ(one.inside(), other.inside());
    EXPECT_EQ(one.on_edges(), other.on_edges());
    EXPECT_EQ(one.points->size(), other.points->size());
}

TEST(ProjectionAxis, IsThatOfTheLargestAreaAndNeverOneWithoutAny) {
    EXPECT_EQ(projection_axis({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 2);
    EXPECT_EQ(projection_axis({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0);
    // A needle whose normal is lost in rounding: one axis alone leaves an area.
    EXPECT_EQ(projection_axis({0, 0, 0}, {1, 0, 1e-30}, {2, 0, 0}), 1);
}

}  // namespace
}  // namespace mq::boolean

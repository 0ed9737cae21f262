// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/constrained_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "base/error.h"
#include "base/point_source.h"
#include "base/predicates.h"

namespace mq::triangulate {
namespace {

using Planar = ConstrainedDelaunay;

Planar triangulation_of(const std::vector<Vec2>& points, std::vector<int>* vertices = nullptr) {
    Vec2 low = points.front();
    Vec2 high = points.front();
    for (const Vec2& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    Planar planar(low, high);
    for (const Vec2& p : points) {
        const int v = planar.insert(p);
        EXPECT_EQ(planar.point(v), p);
        if (vertices != nullptr) {
            vertices->push_back(v);
        }
    }
    return planar;
}

/// Checks links, labels and orientation, and that every edge without a label is locally Delaunay, which implies that
/// the whole triangulation is constrained Delaunay.
void expect_valid(const Planar& planar) {
    ASSERT_EQ(planar.triangle_count(), 2 * planar.vertex_count() - 6);
    for (int h = 0; h < 3 * planar.triangle_count(); ++h) {
        const int a = planar.corner(h);
        const int b = planar.corner(Planar::next(h));
        const int c = planar.corner(Planar::prev(h));
        if (h % 3 == 0) {
            ASSERT_GT(orient2d(planar.point(a), planar.point(b), planar.point(c)), 0) << "triangle " << h / 3;
        }
        const int g = planar.twin(h);
        if (g < 0) {
            ASSERT_LT(std::max(a, b), Planar::kFrame);
            continue;
        }
        ASSERT_EQ(planar.twin(g), h);
        ASSERT_EQ(planar.corner(g), b);
        ASSERT_EQ(planar.corner(Planar::next(g)), a);
        ASSERT_EQ(planar.label(g), planar.label(h));
        if (planar.label(h) < 0) {
            const int d = planar.corner(Planar::prev(g));
            ASSERT_LE(in_circle(planar.point(a), planar.point(b), planar.point(c), planar.point(d)), 0)
                << "edge " << a << "-" << b;
        }
    }
}

std::map<std::pair<int, int>, int> labelled_edges(const Planar& planar) {
    std::map<std::pair<int, int>, int> result;
    for (int h = 0; h < 3 * planar.triangle_count(); ++h) {
        if (planar.label(h) >= 0) {
            result[std::minmax(planar.corner(h), planar.corner(Planar::next(h)))] = planar.label(h);
        }
    }
    return result;
}

bool strictly_between(const Vec2& a, const Vec2& b, const Vec2& p) {
    return p != a && p != b && orient2d(a, b, p) == 0 && (p - a).dot(b - a) > 0.0 && (p - b).dot(a - b) > 0.0;
}

bool properly_crosses(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

/// Checks that the constraint from a to b exists, in pieces between the vertices that lie on it.
void expect_present(const Planar& planar, int a, int b, int label) {
    const Vec2 pa = planar.point(a);
    const Vec2 pb = planar.point(b);
    std::map<double, int> on{{0.0, a}, {(pb - pa).squaredNorm(), b}};
    for (int v = Planar::kFrame; v < planar.vertex_count(); ++v) {
        if (strictly_between(pa, pb, planar.point(v))) {
            on[(planar.point(v) - pa).dot(pb - pa)] = v;
        }
    }
    for (auto it = on.begin(); std::next(it) != on.end(); ++it) {
        const int h = planar.find_edge(it->second, std::next(it)->second);
        ASSERT_GE(h, 0) << "no edge " << it->second << "-" << std::next(it)->second;
        EXPECT_EQ(planar.label(h), label);
    }
}

class PlanarPointsTest : public testing::TestWithParam<Points> {};

INSTANTIATE_TEST_SUITE_P(Points, PlanarPointsTest, testing::ValuesIn(kAllPoints),
                         [](const auto& parameter) { return name_of(parameter.param); });

TEST_P(PlanarPointsTest, AreDelaunay) {
    PointSource source(GetParam(), 31);
    for (const int count : {1, 2, 3, 7, 40, 150}) {
        for (int round = 0; round < 3; ++round) {
            std::vector<int> vertices;
            const Planar planar = triangulation_of(source.take_plane(count), &vertices);
            expect_valid(planar);
            for (const int v : vertices) {
                EXPECT_GE(v, Planar::kFrame);
            }
        }
    }
}

TEST(ConstrainedDelaunay, HoldsGridsLinesAndCircles) {
    std::vector<Vec2> grid;
    std::vector<Vec2> line;
    std::vector<Vec2> circle;
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) {
            grid.emplace_back(0.25 * i, 0.5 * j);
        }
        line.emplace_back(i * i, -2.0 * i * i);
        for (const Vec2& p : {Vec2(3, 4), Vec2(4, 3), Vec2(5, 0)}) {  // exactly on one circle
            circle.emplace_back(i % 2 == 0 ? p.x() : -p.x(), i % 4 < 2 ? p.y() : -p.y());
        }
    }
    for (std::vector<Vec2> points : {grid, line, circle}) {
        expect_valid(triangulation_of(points));
        std::shuffle(points.begin(), points.end(), std::mt19937(3));
        expect_valid(triangulation_of(points));
    }
}

TEST(ConstrainedDelaunay, TakesABoxWithoutExtentFarFromTheOrigin) {
    const Vec2 p(1e9, 0.0);
    Planar planar(p, p);
    EXPECT_EQ(planar.insert(p), Planar::kFrame);
    expect_valid(planar);
}

TEST(ConstrainedDelaunay, FlipsOnlyConvexPairsWithoutAConstraint) {
    std::vector<int> v;
    Planar planar = triangulation_of({{0.0, 0.0}, {4.0, 0.0}, {3.0, 3.0}, {0.0, 4.0}}, &v);
    const int diagonal = planar.find_edge(v[0], v[2]);
    ASSERT_GE(diagonal, 0);
    EXPECT_FALSE(planar.flip_edge(planar.find_edge(v[1], v[2]))) << "seen from the frame there is a notch";
    EXPECT_TRUE(planar.flip_edge(diagonal));
    EXPECT_EQ(planar.find_edge(v[0], v[2]), -1);
    const int other = planar.find_edge(v[1], v[3]);
    ASSERT_GE(other, 0);
    EXPECT_TRUE(planar.flip_edge(other));
    ASSERT_FALSE(planar.insert_constraint(v[0], v[2], 5));
    EXPECT_FALSE(planar.flip_edge(planar.find_edge(v[0], v[2])));
    expect_valid(planar);
}

/// Among flipped edges the walk to a point can cycle.
TEST(ConstrainedDelaunay, FindsPointsAmongFlippedEdges) {
    for (unsigned seed = 0; seed < 300; ++seed) {
        std::mt19937 random(seed);
        const auto coordinate = [&] { return static_cast<double>(random()) / 4294967296.0; };
        Planar planar(Vec2(0.0, 0.0), Vec2(1.0, 1.0));
        for (int i = 0; i < 60; ++i) {
            const Vec2 p(coordinate(), coordinate());
            ASSERT_EQ(planar.insert(p), Planar::kFrame + i);
            for (int k = 0; k < 200; ++k) {
                planar.flip_edge(static_cast<int>(random() % (3 * static_cast<unsigned>(planar.triangle_count()))));
            }
        }
    }
}

TEST(ConstrainedDelaunay, RefusesPointsOutsideOfItsFrame) {
    Planar planar(Vec2(0.0, 0.0), Vec2(1.0, 1.0));
    EXPECT_THROW(planar.insert(Vec2(1e3, 0.0)), InvalidInput);
}

TEST(ConstrainedDelaunay, FindsDuplicates) {
    std::vector<Vec2> points = PointSource(Points::kGrid, 5).take_plane(60);
    std::vector<int> first;
    Planar planar = triangulation_of(points, &first);
    const int count = planar.vertex_count();
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(planar.insert(points[i]), first[i]);
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_EQ(first[i] == first[k], points[i] == points[k]);
        }
    }
    EXPECT_EQ(planar.vertex_count(), count);
}

TEST(ConstrainedDelaunay, FindsEdgesBothWaysAndNoOthers) {
    const Planar planar = triangulation_of(PointSource(Points::kRandom, 6).take_plane(30));
    std::set<std::pair<int, int>> edges;
    for (int h = 0; h < 3 * planar.triangle_count(); ++h) {
        edges.emplace(planar.corner(h), planar.corner(Planar::next(h)));
    }
    for (int a = 0; a < planar.vertex_count(); ++a) {
        for (int b = 0; b < planar.vertex_count(); ++b) {
            const int h = a == b ? -1 : planar.find_edge(a, b);
            ASSERT_EQ(h >= 0, a != b && edges.count({a, b}) > 0) << a << "-" << b;
            if (h >= 0) {
                EXPECT_EQ(planar.corner(h), a);
                EXPECT_EQ(planar.corner(Planar::next(h)), b);
            }
        }
    }
}

TEST(ConstrainedDelaunay, NamesAVertexOnTheConstraint) {
    std::vector<int> v;
    Planar planar = triangulation_of({Vec2(0, 0), Vec2(4, 2), Vec2(2, 1), Vec2(1, 3), Vec2(3, 0)}, &v);
    const auto obstacle = planar.insert_constraint(v[0], v[1], 7);
    ASSERT_TRUE(obstacle);
    EXPECT_EQ(obstacle->vertex, v[2]);
    EXPECT_TRUE(labelled_edges(planar).empty());
    EXPECT_FALSE(planar.insert_constraint(v[0], v[2], 7));
    EXPECT_FALSE(planar.insert_constraint(v[2], v[1], 7));
    expect_valid(planar);
    expect_present(planar, v[0], v[1], 7);
}

TEST(ConstrainedDelaunay, NamesAConstraintInTheWay) {
    std::vector<int> v;
    Planar planar = triangulation_of({Vec2(0, 0), Vec2(4, 0), Vec2(2, -3), Vec2(2, 3), Vec2(3, -2), Vec2(3, 2)}, &v);
    EXPECT_FALSE(planar.insert_constraint(v[2], v[3], 1));
    EXPECT_FALSE(planar.insert_constraint(v[4], v[5], 2));
    const auto labels = labelled_edges(planar);
    const auto from_left = planar.insert_constraint(v[0], v[1], 3);
    ASSERT_TRUE(from_left);
    EXPECT_EQ(from_left->constraint, 1);
    const auto from_right = planar.insert_constraint(v[1], v[0], 3);
    ASSERT_TRUE(from_right);
    EXPECT_EQ(from_right->constraint, 2);
    EXPECT_EQ(labelled_edges(planar), labels);
    expect_valid(planar);
}

TEST(ConstrainedDelaunay, PointsOnAConstraintSplitIt) {
    std::vector<int> v;
    Planar planar = triangulation_of({Vec2(0, 0), Vec2(8, 4), Vec2(3, 5), Vec2(5, -1)}, &v);
    EXPECT_FALSE(planar.insert_constraint(v[0], v[1], 9));
    for (const double x : {4.0, 2.0, 6.0, 1.0, 7.5}) {
        planar.insert(Vec2(x, 0.5 * x));
        expect_valid(planar);
        expect_present(planar, v[0], v[1], 9);
    }
    EXPECT_EQ(labelled_edges(planar).size(), 6u);
}

TEST(ConstrainedDelaunay, AConstraintKeepsItsFirstLabel) {
    std::vector<int> v;
    Planar planar = triangulation_of({Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, &v);
    EXPECT_FALSE(planar.insert_constraint(v[0], v[1], 4));
    EXPECT_FALSE(planar.insert_constraint(v[1], v[0], 5));
    expect_present(planar, v[0], v[1], 4);
}

std::vector<Vec2> star_polygon(int tips) {
    std::vector<Vec2> points;
    for (int i = 0; i < 2 * tips; ++i) {
        const double r = i % 2 == 0 ? 10.0 : 0.3;
        points.emplace_back(r * std::cos(M_PI * i / tips), r * std::sin(M_PI * i / tips));
    }
    return points;
}

/// A spiral that runs inwards along one arm and returns along another close beside it.
std::vector<Vec2> spiral(int count) {
    std::vector<Vec2> points;
    for (int i = 0; i < 2 * count; ++i) {
        const double turn = 0.35 * (i < count ? i : 2 * count - 1 - i);
        const double r = 1.0 + 0.2 * turn + (i < count ? 0.0 : 0.01);
        points.emplace_back(r * std::cos(turn), r * std::sin(turn));
    }
    return points;
}

std::vector<Vec2> comb(int teeth) {
    std::vector<Vec2> points;
    for (int i = 0; i < teeth; ++i) {
        points.emplace_back(i, 0.0);
        points.emplace_back(i + 0.001, 50.0);
        points.emplace_back(i + 0.002, 0.0);
    }
    points.emplace_back(teeth, -1.0);
    points.emplace_back(-1.0, -1.0);
    return points;
}

TEST(ConstrainedDelaunay, HoldsTheEdgesOfSlenderPolygons) {
    std::mt19937 random(17);
    for (const std::vector<Vec2>& polygon : {star_polygon(25), spiral(60), comb(20)}) {
        std::vector<int> v;
        Planar planar = triangulation_of(polygon, &v);
        const int n = static_cast<int>(polygon.size());
        std::vector<int> order(n);
        for (int i = 0; i < n; ++i) {
            order[i] = i;
        }
        std::shuffle(order.begin(), order.end(), random);
        for (const int i : order) {
            ASSERT_FALSE(planar.insert_constraint(v[i], v[(i + 1) % n], i)) << "edge " << i;
        }
        expect_valid(planar);
        std::uniform_real_distribution<double> part(0.0, 1.0);
        for (int i = 0; i < 200; ++i) {
            const Vec2 a = polygon[i % n];
            const Vec2 b = polygon[(i * 7 + 3) % n];
            planar.insert(a + part(random) * (b - a));
        }
        expect_valid(planar);
        EXPECT_GE(static_cast<int>(labelled_edges(planar).size()), n);
    }
}

/// Returns where the constraint or the vertex is met along a-b, as a fraction of its length.
double place_along(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const Vec2 normal(d.y() - c.y(), c.x() - d.x());
    return (c - a).dot(normal) / (b - a).dot(normal);
}

struct Reference {
    double first = 2.0;               // place of the first obstacle
    std::set<int> vertices;           // all vertices on the constraint
    std::map<int, double> crossings;  // labels of all constraints that it would cross

    bool any() const { return !vertices.empty() || !crossings.empty(); }
};

Reference obstacles(const Planar& planar, int a, int b) {
    Reference result;
    const Vec2 pa = planar.point(a);
    const Vec2 pb = planar.point(b);
    for (int v = Planar::kFrame; v < planar.vertex_count(); ++v) {
        if (strictly_between(pa, pb, planar.point(v))) {
            result.vertices.insert(v);
            result.first = std::min(result.first, (planar.point(v) - pa).dot(pb - pa) / (pb - pa).squaredNorm());
        }
    }
    for (const auto& [ends, label] : labelled_edges(planar)) {
        const Vec2 c = planar.point(ends.first);
        const Vec2 d = planar.point(ends.second);
        if (properly_crosses(pa, pb, c, d)) {
            result.crossings[label] = place_along(pa, pb, c, d);
            result.first = std::min(result.first, result.crossings[label]);
        }
    }
    return result;
}

/// Checks that the named obstacle is one and, unless places differ by rounding only, is met first.
void expect_named(const Planar& planar, int a, int b, const Planar::Obstacle& obstacle, const Reference& all,
                  bool exact_ties) {
    const Vec2 pa = planar.point(a);
    const Vec2 pb = planar.point(b);
    double place = 2.0;
    if (obstacle.vertex >= 0) {
        ASSERT_EQ(all.vertices.count(obstacle.vertex), 1u);
        place = (planar.point(obstacle.vertex) - pa).dot(pb - pa) / (pb - pa).squaredNorm();
    } else {
        ASSERT_EQ(all.crossings.count(obstacle.constraint), 1u);
        place = all.crossings.at(obstacle.constraint);
    }
    if (!exact_ties) {
        EXPECT_NEAR(place, all.first, 1e-9);
    }
}

/// Constraints between random vertices of a coarse grid, of which many pass through vertices or meet others: each is
/// inserted exactly if there is no obstacle, and otherwise the first obstacle is named.
TEST_P(PlanarPointsTest, TakeEveryConstraintThatNothingStandsInTheWayOf) {
    const bool exact_ties = GetParam() != Points::kRandom && GetParam() != Points::kSingle;
    PointSource source(GetParam(), 41);
    for (int round = 0; round < 10; ++round) {
        std::vector<int> v;
        Planar planar = triangulation_of(source.take_plane(40), &v);
        std::map<std::pair<int, int>, int> taken;
        for (int label = 0; label < 120; ++label) {
            const int a = v[source.integer(0, 39)];
            const int b = v[source.integer(0, 39)];
            if (a == b || taken.count(std::minmax(a, b)) > 0) {
                continue;
            }
            const Reference all = obstacles(planar, a, b);
            const auto labels = labelled_edges(planar);
            const auto obstacle = planar.insert_constraint(a, b, label);
            ASSERT_EQ(obstacle.has_value(), all.any()) << a << "-" << b;
            if (obstacle) {
                ASSERT_NO_FATAL_FAILURE(expect_named(planar, a, b, *obstacle, all, exact_ties));
                ASSERT_EQ(labelled_edges(planar), labels);
            } else {
                taken[std::minmax(a, b)] = label;
            }
        }
        ASSERT_NO_FATAL_FAILURE(expect_valid(planar));
        for (const auto& [ends, label] : taken) {
            ASSERT_NO_FATAL_FAILURE(expect_present(planar, ends.first, ends.second, label));
        }
    }
}

}  // namespace
}  // namespace mq::triangulate

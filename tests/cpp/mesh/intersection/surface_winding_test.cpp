// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/surface_winding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mq::mesh {
namespace {

/// A sphere of radius 1 around the origin, in 2 n by n facets, without those above a height.
TriangleMesh bowl(int n, double height) {
    TriangleMesh mesh;
    for (int row = 0; row <= n; ++row) {
        const double polar = M_PI * row / n;
        for (int i = 0; i < (row % n == 0 ? 1 : 2 * n); ++i) {
            const double around = M_PI * i / n;
            mesh.vertices.emplace_back(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                                       std::cos(polar));
        }
    }
    const auto at = [n](int row, int i) {
        return row == 0 ? 0 : row == n ? 1 + (n - 1) * 2 * n : 1 + (row - 1) * 2 * n + i % (2 * n);
    };
    for (int row = 0; row < n; ++row) {
        for (int i = 0; i < 2 * n; ++i) {
            for (const Triangle& t : {Triangle{at(row, i), at(row + 1, i), at(row + 1, i + 1)},
                                      Triangle{at(row, i), at(row + 1, i + 1), at(row, i + 1)}}) {
                const bool flat = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
                const double z = (mesh.vertices[t[0]].z() + mesh.vertices[t[1]].z() + mesh.vertices[t[2]].z()) / 3.0;
                if (!flat && z < height) {
                    mesh.triangles.push_back(t);
                }
            }
        }
    }
    return mesh;
}

/// By the sum over all triangles.
double exactly(const TriangleMesh& mesh, const Vec3& p) {
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p, c = mesh.vertices[t[2]] - p;
        sum += 2.0 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                       b.dot(c) * a.norm() + c.dot(a) * b.norm());
    }
    return sum / (4.0 * M_PI);
}

class Points {
  public:
    Vec3 next() { return Vec3(coordinate(), coordinate(), coordinate()); }

  private:
    double coordinate() { return 3.0 * (random_() / 4294967295.0 - 0.5); }
    std::mt19937 random_{5};
};

TEST(SurfaceWinding, IsOneInsideAndZeroOutsideOfAClosedSurface) {
    const TriangleMesh ball = bowl(20, 2.0);
    const SurfaceWinding winding(ball.vertices, ball.triangles);
    EXPECT_TRUE(winding.border().empty());
    Points points;
    for (int k = 0; k < 500; ++k) {
        const Vec3 p = points.next();
        if (std::abs(p.norm() - 1.0) > 0.02) {
            EXPECT_NEAR(winding.at(p), p.norm() < 1.0 ? 1.0 : 0.0, 0.003) << p.transpose();
        }
        EXPECT_EQ(winding.gradient(p), Vec3(Vec3::Zero()));
        EXPECT_EQ(winding.steepest(p, 0.1), 0.0);
    }
}

TEST(SurfaceWinding, IsThatOfAllTrianglesTakenSingly) {
    for (const double height : {0.9, 0.5, 0.0}) {
        const TriangleMesh open = bowl(30, height);
        const SurfaceWinding winding(open.vertices, open.triangles);
        EXPECT_EQ(winding.border().size(), 60U);
        Points points;
        double largest = 0.0;
        for (int k = 0; k < 1000; ++k) {
            const Vec3 p = points.next();
            largest = std::max(largest, std::abs(winding.at(p) - exactly(open, p)));
        }
        EXPECT_LT(largest, 0.003);
    }
    // Half a ball's solid angle from its middle is half of the whole.
    const TriangleMesh half = bowl(30, 0.0);
    EXPECT_NEAR(SurfaceWinding(half.vertices, half.triangles).at(Vec3::Zero()), 0.5, 1e-3);
}

TEST(SurfaceWinding, GradientIsThatOfTheNumberAndWithinTheBound) {
    const TriangleMesh open = bowl(30, 0.5);
    const SurfaceWinding winding(open.vertices, open.triangles);
    Points points;
    constexpr double kStep = 1e-4;
    int compared = 0;
    for (int k = 0; k < 500; ++k) {
        const Vec3 p = points.next();
        const double rim = (Vec3(std::hypot(p.x(), p.y()), 0.0, p.z()) - Vec3(std::sqrt(0.75), 0.0, 0.5)).norm();
        if (std::abs(p.norm() - 1.0) < 0.05 || rim < 0.3) {
            continue;
        }
        ++compared;
        Vec3 difference;
        for (int a = 0; a < 3; ++a) {
            const Vec3 step = kStep * Vec3::Unit(a);
            difference[a] = (exactly(open, p + step) - exactly(open, p - step)) / (2.0 * kStep);
        }
        const Vec3 gradient = winding.gradient(p);
        EXPECT_LT((gradient - difference).norm(), 0.05 * difference.norm() + 1e-3) << p.transpose();
        EXPECT_LE(gradient.norm(), winding.steepest(p, 0.0) * 1.05);
        const Vec3 beside = p + 0.1 * points.next().normalized();
        EXPECT_LE(winding.gradient(beside).norm(), winding.steepest(p, 0.1) * 1.05);
    }
    EXPECT_GT(compared, 200);
    EXPECT_TRUE(std::isinf(winding.steepest(open.vertices[static_cast<std::size_t>(winding.border()[0][0])], 0.01)));
}

/// Reversed triangles and triangles that occur twice have a border, too.
TEST(SurfaceWinding, BorderIsWhereTheTrianglesAreNotInBalance) {
    TriangleMesh ball = bowl(10, 2.0);
    ball.triangles.push_back(ball.triangles[50]);
    EXPECT_EQ(SurfaceWinding(ball.vertices, ball.triangles).border().size(), 3U);
    ball.triangles.pop_back();
    std::swap(ball.triangles[50][0], ball.triangles[50][1]);
    EXPECT_EQ(SurfaceWinding(ball.vertices, ball.triangles).border().size(), 6U);
}

}  // namespace
}  // namespace mq::mesh

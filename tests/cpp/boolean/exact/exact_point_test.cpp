// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/exact/exact_point.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace mq::boolean {
namespace {

using Rational = std::array<mpq_class, 3>;

Rational rational(const Vec3& p) {
    return {mpq_class(p.x()), mpq_class(p.y()), mpq_class(p.z())};
}
Rational minus(const Rational& a, const Rational& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Rational cross(const Rational& a, const Rational& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpq_class dot(const Rational& a, const Rational& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A point in both representations.
struct Both {
    ExactPoint exact;
    Rational rational;
};

/// Points on a coarse grid, so that many of them coincide or lie in one line or plane.
class Source {
  public:
    explicit Source(unsigned seed) : random_(seed) {}

    Vec3 given() {
        const double unit = fine_ ? 1.0 / 4096.0 : 1.0;
        const int range = fine_ ? 40960 : 3;
        std::uniform_int_distribution<int> pick(-range, range);
        return unit * Vec3(pick(random_), pick(random_), pick(random_));
    }
    PlanePoints plane() {
        for (;;) {
            const PlanePoints p{given(), given(), given()};
            if (!(p[1] - p[0]).cross(p[2] - p[0]).isZero(0.0)) {
                return p;
            }
        }
    }
    Both point() {
        fine_ = random_() % 2 == 0;
        switch (random_() % 3) {
            case 0: {
                const Vec3 p = given();
                return {ExactPoint(p), rational(p)};
            }
            case 1:
                return on_line();
            default:
                return on_planes();
        }
    }

  private:
    Both on_line() {
        for (;;) {
            const PlanePoints plane = this->plane();
            const Vec3 p = given();
            const Vec3 q = given();
            const Rational a = rational(plane[0]);
            const Rational n = cross(minus(rational(plane[1]), a), minus(rational(plane[2]), a));
            const mpq_class at_p = dot(n, minus(rational(p), a));
            const mpq_class at_q = dot(n, minus(rational(q), a));
            if (at_p == at_q) {
                continue;
            }
            Rational r;
            for (int k = 0; k < 3; ++k) {
                r[k] = mpq_class(p[k]) + (mpq_class(q[k]) - mpq_class(p[k])) * at_p / (at_p - at_q);
            }
            return {ExactPoint::on_line(p, q, plane), r};
        }
    }

    Both on_planes() {
        for (;;) {
            const PlanePoints plane[3] = {this->plane(), this->plane(), this->plane()};
            Rational n[3];
            mpq_class d[3];
            for (int i = 0; i < 3; ++i) {
                const Rational a = rational(plane[i][0]);
                n[i] = cross(minus(rational(plane[i][1]), a), minus(rational(plane[i][2]), a));
                d[i] = dot(n[i], a);
            }
            const mpq_class det = dot(n[0], cross(n[1], n[2]));
            if (det == 0) {
                continue;
            }
            Rational r;
            for (int k = 0; k < 3; ++k) {
                r[k] = (d[0] * cross(n[1], n[2])[k] + d[1] * cross(n[2], n[0])[k] + d[2] * cross(n[0], n[1])[k]) / det;
            }
            return {ExactPoint::on_planes(plane[0], plane[1], plane[2]), r};
        }
    }

    std::mt19937 random_;
    bool fine_ = false;
};

TEST(ExactPoint, ConstructedPointsAreWithinTheirError) {
    Source source(1);
    for (int i = 0; i < 3000; ++i) {
        const Both p = source.point();
        for (int k = 0; k < 3; ++k) {
            const mpq_class off = abs(mpq_class(p.exact.approx()[k]) - p.rational[k]);
            ASSERT_LE(off, mpq_class(p.exact.error())) << "case " << i;
        }
    }
}

TEST(ExactPoint, ComparesExactly) {
    Source source(2);
    int equal = 0;
    for (int i = 0; i < 3000; ++i) {
        const Both p = source.point();
        const Both q = source.point();
        for (int axis = 0; axis < 3; ++axis) {
            const int expected = cmp(p.rational[axis], q.rational[axis]);
            ASSERT_EQ(compare(p.exact, q.exact, axis), (expected > 0) - (expected < 0)) << "case " << i;
            equal += expected == 0 ? 1 : 0;
        }
        ASSERT_EQ(coincide(p.exact, q.exact), p.rational == q.rational) << "case " << i;
        ASSERT_TRUE(coincide(p.exact, p.exact));
    }
    EXPECT_GT(equal, 50) << "too few ties to tell";
}

TEST(ExactPoint, OrientationsAreExact) {
    Source source(3);
    int ties = 0;
    for (int i = 0; i < 3000; ++i) {
        const Both p[4] = {source.point(), source.point(), source.point(), source.point()};
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            const Rational a = minus(p[1].rational, p[0].rational);
            const Rational b = minus(p[2].rational, p[0].rational);
            const int expected = sgn(mpq_class(a[u] * b[v] - a[v] * b[u]));
            ASSERT_EQ(orient2d(p[0].exact, p[1].exact, p[2].exact, axis), expected) << "case " << i;
            ties += expected == 0 ? 1 : 0;
        }
        const PlanePoints plane = source.plane();
        const Rational o = rational(plane[0]);
        const Rational n = cross(minus(rational(plane[1]), o), minus(rational(plane[2]), o));
        const int expected = sgn(dot(n, minus(p[3].rational, o)));
        ASSERT_EQ(side_of(plane, p[3].exact), expected) << "case " << i;
        ties += expected == 0 ? 1 : 0;
    }
    EXPECT_GT(ties, 20) << "too few ties to tell";
}

TEST(ExactPoint, ConstructedDoublesAreGivenPoints) {
    Source source(4);
    int constructed = 0;
    for (int i = 0; i < 3000; ++i) {
        const Both p = source.point();
        if (p.exact.given()) {
            ASSERT_EQ(rational(p.exact.approx()), p.rational) << "case " << i;
        } else {
            ++constructed;
            ASSERT_GT(p.exact.error(), 0.0) << "case " << i;
        }
    }
    EXPECT_GT(constructed, 1000) << "too few points that are no doubles";
}

TEST(ExactPoint, CornersOfBoxesAreGivenPoints) {
    const PlanePoints x{Vec3(0.1, 0, 0), Vec3(0.1, 1, 0.3), Vec3(0.1, 0.7, 2)};
    const PlanePoints y{Vec3(0, 0.2, 0), Vec3(1, 0.2, 0.3), Vec3(0.7, 0.2, 2)};
    const PlanePoints z{Vec3(0, 0, 0.7), Vec3(1, 0.3, 0.7), Vec3(0.7, 2, 0.7)};
    const ExactPoint corner = ExactPoint::on_planes(x, y, z);
    EXPECT_TRUE(corner.given());
    EXPECT_EQ(corner.approx(), Vec3(0.1, 0.2, 0.7));
    const ExactPoint on_edge = ExactPoint::on_line(Vec3(0, 0.2, 0.7), Vec3(1, 0.2, 0.7), x);
    EXPECT_TRUE(on_edge.given());
    EXPECT_EQ(on_edge.approx(), Vec3(0.1, 0.2, 0.7));
    EXPECT_FALSE(ExactPoint::on_line(Vec3(0, 0, 0), Vec3(1, 3, 0.7), x).given());
}

}  // namespace
}  // namespace mq::boolean

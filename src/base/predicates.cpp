// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>

#include "base/double_double.h"
#include "base/expansion.h"

// Derivation of the error bounds below.
//
// u = 2^-53 is the unit roundoff: barring over- and underflow, every operation returns its exact result times (1 + d),
// |d| <= u. That includes the difference of two coordinates, as the coordinates themselves are exact. A computed
// polynomial is then the sum of its exact monomials, each times k such factors, where k counts the operations that the
// monomial went through. Its error is at most ((1 + u)^k - 1) S < (k + 1/2) u S, with S the sum of the absolute values
// of the exact monomials. The computed S is at least S (1 - u)^k' with a small k'; taking (k + 1) u times the computed
// S covers that too, and the rounding of the bound, since u is far below 1 / (2 (k + 1) (k' + 2)).
//
// The error is strictly below the bound unless both are zero, so that |value| >= bound decides the sign.
namespace mq {
namespace {

/// The unit roundoff u = 2^-53.
constexpr double kUnit = 0.5 * std::numeric_limits<double>::epsilon();

constexpr double rounding_bound(int operations) {
    return (operations + 1) * kUnit;
}

int sign_of(double value) {
    return (value > 0.0) - (value < 0.0);
}

/// Counts the answer, and returns whether the filter gave it.
bool settled(bool by_filter) {
    PredicateCount& count = predicate_count();
    ++(by_filter ? count.filtered : count.exact);
    return by_filter;
}

using ExactVec = std::array<Expansion, 3>;

ExactVec exact_difference(const Vec3& a, const Vec3& b) {
    return {Expansion::difference(a.x(), b.x()), Expansion::difference(a.y(), b.y()),
            Expansion::difference(a.z(), b.z())};
}

Expansion exact_dot(const ExactVec& a, const ExactVec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Expansion exact_squared_distance(const Vec3& a, const Vec3& b) {
    const ExactVec d = exact_difference(a, b);
    return exact_dot(d, d).compressed();
}

double dot(const Vec3& a, const Vec3& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

double dot_magnitude(const Vec3& a, const Vec3& b) {
    return std::abs(a.x() * b.x()) + std::abs(a.y() * b.y()) + std::abs(a.z() * b.z());
}

/// Operations of a monomial of a dot product of two differences: two differences, a product, two sums.
constexpr int kDotOperations = 5;

// ---- smallest angles of triangles ---------------------------------------------------------------------------------

/// The error of sin^2 of the smallest angle of a triangle. With a, b the edge vectors of the cross product C and A =
/// |a|^2 |b|^2:
///
/// A component of C takes 4 operations (two differences, product, difference). The vector of the sums of its absolute
/// monomials, |a_y b_z| + |a_z b_y| and so on, is sqrt(2 A) long at most, because by Cauchy-Schwarz its squared length
/// is at most sum_i (|a|^2 - a_i^2) (|b|^2 - b_i^2) = A + sum_i a_i^2 b_i^2 <= 2 A. So the error of C is at most e = 4
/// sqrt(2 A) u, and that of |C|^2 is 2 |C| e + e^2 <= 8 sqrt(2) A u and terms in u^2. Squaring and adding up |C|^2
/// takes 3 operations, and |C|^2 <= A: 8 sqrt(2) + 3 < 14.4 units of A, and A <= B. B, the product of the squares of
/// the two longer edges, takes 5 + 5 + 1 operations: the largest of the three rounded products is the rounded largest,
/// as rounding is monotone. With the quotient that makes 12, relative to sin^2 <= 3/4 for the smallest angle: 9 units
/// more. Together below 23.5 units; 24 covers the terms in u^2.
constexpr double kSineError = 24.0 * kUnit;
/// Bound of the error of the difference of two such values, and one unit for the rounding of the difference.
constexpr double kSineBound = 2.0 * kSineError + kUnit;

enum Side { kPQ, kPR, kPS, kQR, kQS, kRS, kSideCount };

/// A triangle by its sides, among those between p, q, r and s, and the computed sin^2 of its smallest angle.
struct Corner {
    std::array<Side, 3> sides;
    double sine;
};

double smallest_sine(const Vec3& a, const Vec3& b, double a2, double b2, double c2) {
    const double x = a.y() * b.z() - a.z() * b.y();
    const double y = a.z() * b.x() - a.x() * b.z();
    const double z = a.x() * b.y() - a.y() * b.x();
    const double longest = std::max(a2 * b2, std::max(b2 * c2, c2 * a2));
    return longest > 0.0 ? (x * x + y * y + z * z) / longest : 0.0;
}

/// The value 4 sin^2 of the smallest angle, as a fraction.
struct ExactSine {
    Expansion numerator;
    Expansion denominator;
};

using ExactSides = std::array<Expansion, kSideCount>;

/// The smallest angle is opposite the shortest side c: 4 sin^2 = (4 a^2 b^2 - (a^2 + b^2 - c^2)^2) / (a^2 b^2). The
/// numerator, 16 times the squared area, is the same for every order of the sides.
ExactSine exact_smallest_sine(const Corner& corner, const ExactSides& squares) {
    const Expansion* a = &squares[corner.sides[0]];
    const Expansion* b = &squares[corner.sides[1]];
    const Expansion* c = &squares[corner.sides[2]];
    if ((*a - *c).sign() < 0) {
        std::swap(a, c);
    }
    if ((*b - *c).sign() < 0) {
        std::swap(b, c);
    }
    const Expansion denominator = *a * *b;
    if (denominator.sign() == 0) {
        return {Expansion(), Expansion(1.0)};
    }
    const Expansion twice_dot = (*a + *b - *c).compressed();
    return {(denominator.scaled(4.0) - twice_dot * twice_dot).compressed(), denominator};
}

int compare_sines(const ExactSine& first, const ExactSine& second) {
    if (same_terms(first.numerator, second.numerator) && same_terms(first.denominator, second.denominator)) {
        return 0;
    }
    return (first.numerator * second.denominator - second.numerator * first.denominator).sign();
}

/// The smaller of two sines; the exact one of a triangle is computed only where the rounded values do not decide.
ExactSine exact_smaller(const Corner& first, const Corner& second, const ExactSides& squares) {
    if (second.sine - first.sine >= kSineBound) {
        return exact_smallest_sine(first, squares);
    }
    if (first.sine - second.sine >= kSineBound) {
        return exact_smallest_sine(second, squares);
    }
    const ExactSine first_exact = exact_smallest_sine(first, squares);
    const ExactSine second_exact = exact_smallest_sine(second, squares);
    return compare_sines(first_exact, second_exact) <= 0 ? first_exact : second_exact;
}

}  // namespace

PredicateCount& predicate_count() {
    static thread_local PredicateCount count;
    return count;
}

int sign_dot(const Vec3& o, const Vec3& a, const Vec3& b) {
    const Vec3 to_a = a - o;
    const Vec3 to_b = b - o;
    const double value = dot(to_a, to_b);
    if (settled(std::abs(value) >= rounding_bound(kDotOperations) * dot_magnitude(to_a, to_b))) {
        return sign_of(value);
    }
    return exact_dot(exact_difference(a, o), exact_difference(b, o)).sign();
}

int obtuse_vertex(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (sign_dot(a, b, c) < 0) {
        return 0;
    }
    if (sign_dot(b, c, a) < 0) {
        return 1;
    }
    return sign_dot(c, a, b) < 0 ? 2 : -1;
}

bool encroached(const Vec3& o, const Vec3& d, const Vec3& p) {
    return sign_dot(p, o, d) < 0;
}

// The smallest angle of a triangle is at most 60 degrees, where its sine grows with the angle, and sin^2 is 4 area^2
// over the squares of the two longer edges. That takes one cross product for each triangle instead of three angles, and
// the error of the minimum of two such values is no larger than theirs. A triangle with two coinciding corners has
// angles of zero.
bool locally_maxmin(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    const Vec3 pq = q - p;
    const Vec3 pr = r - p;
    const Vec3 ps = s - p;
    const Vec3 qr = r - q;
    const Vec3 qs = s - q;
    const Vec3 rs = s - r;
    const double pq2 = dot(pq, pq);
    const double pr2 = dot(pr, pr);
    const double ps2 = dot(ps, ps);
    const double qr2 = dot(qr, qr);
    const double qs2 = dot(qs, qs);
    const double rs2 = dot(rs, rs);
    const Corner pqr{{kPQ, kPR, kQR}, smallest_sine(pq, pr, pq2, pr2, qr2)};
    const Corner qps{{kPQ, kPS, kQS}, smallest_sine(pq, ps, pq2, ps2, qs2)};
    const Corner rsq{{kRS, kQR, kQS}, smallest_sine(rs, qr, rs2, qr2, qs2)};
    const double now = std::min(pqr.sine, qps.sine);
    if (now - rsq.sine >= kSineBound) {  // most edges: the second new triangle could only make the swap worse
        return settled(true);
    }
    const Corner srp{{kRS, kPR, kPS}, smallest_sine(rs, pr, rs2, pr2, ps2)};
    const double gain = now - std::min(rsq.sine, srp.sine);
    if (settled(std::abs(gain) >= kSineBound)) {
        return gain > 0.0;
    }
    const ExactSides squares{exact_squared_distance(p, q), exact_squared_distance(p, r), exact_squared_distance(p, s),
                             exact_squared_distance(q, r), exact_squared_distance(q, s), exact_squared_distance(r, s)};
    return compare_sines(exact_smaller(pqr, qps, squares), exact_smaller(rsq, srp, squares)) >= 0;
}

// Four operations a monomial: two differences, a product, a difference.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    const double value = left - right;
    if (settled(std::abs(value) >= rounding_bound(4) * (std::abs(left) + std::abs(right)))) {
        return sign_of(value);
    }
    return (Expansion::difference(a.x(), c.x()) * Expansion::difference(b.y(), c.y()) -
            Expansion::difference(a.y(), c.y()) * Expansion::difference(b.x(), c.x()))
        .sign();
}

int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    return orient2d(Vec2(a[i], a[j]), Vec2(b[i], b[j]), Vec2(c[i], c[j]));
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto flat = [&](int x, int y) { return orient2d(Vec2(a[x], a[y]), Vec2(b[x], b[y]), Vec2(c[x], c[y])) == 0; };
    return flat(0, 1) && flat(1, 2) && flat(2, 0);
}

namespace {

/// The exponent of the lowest bit that is set in any of the numbers.
int lowest_bit(std::initializer_list<double> numbers) {
    int lowest = std::numeric_limits<double>::max_exponent;
    for (const double number : numbers) {
        int exponent = 0;
        const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(number, &exponent), 53));
        if (mantissa != 0) {
            lowest = std::min(lowest, exponent - 53 + std::ilogb(static_cast<double>(mantissa & -mantissa)));
        }
    }
    return lowest;
}

/// The sign of the determinant by double-doubles, or nothing where they do not decide. Their differences are exact, and
/// a monomial goes through five further operations, each with a relative error of at most 15 * 2^-106. The determinant
/// is a multiple of the product of the lowest bits of the three coordinates: below that it is zero.
std::optional<int> orient3d_in_double_doubles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const DoubleDoubleVec da = difference(a, d);
    const DoubleDoubleVec db = difference(b, d);
    const DoubleDoubleVec dc = difference(c, d);
    const double value = dot(da, cross(db, dc)).high;
    const double magnitude = magnitudes(da).dot(cross_of_magnitudes(magnitudes(db), magnitudes(dc)));
    const double bound = 6.0 * 15.0 * 0x1p-106 * magnitude;
    if (std::abs(value) >= bound && value != 0.0) {
        return -sign_of(value);
    }
    int unit = 0;
    for (int i = 0; i < 3; ++i) {
        unit += lowest_bit({a[i], b[i], c[i], d[i]});
    }
    return std::abs(value) + 2.0 * bound < std::ldexp(1.0, unit) ? std::optional(0) : std::nullopt;
}

int exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    if (const std::optional<int> sign = orient3d_in_double_doubles(a, b, c, d)) {
        return *sign;
    }
    const ExactVec da = exact_difference(a, d);
    const ExactVec db = exact_difference(b, d);
    const ExactVec dc = exact_difference(c, d);
    Expansion sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        sum = sum + da[i] * (db[j] * dc[k] - db[k] * dc[j]).compressed();
    }
    return -sum.sign();
}

}  // namespace

// Minus the determinant of the rows a - d, b - d, c - d. A monomial takes three differences, the product and the
// difference of the minor, one product, and two sums: 8.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 da = a - d;
    const Vec3 db = b - d;
    const Vec3 dc = c - d;
    const double bc = db.y() * dc.z();
    const double cb = db.z() * dc.y();
    const double ca = db.z() * dc.x();
    const double ac = db.x() * dc.z();
    const double ab = db.x() * dc.y();
    const double ba = db.y() * dc.x();
    const double value = da.x() * (bc - cb) + da.y() * (ca - ac) + da.z() * (ab - ba);
    const double magnitude = std::abs(da.x()) * (std::abs(bc) + std::abs(cb)) +
                             std::abs(da.y()) * (std::abs(ca) + std::abs(ac)) +
                             std::abs(da.z()) * (std::abs(ab) + std::abs(ba));
    if (settled(std::abs(value) >= rounding_bound(8) * magnitude)) {
        return -sign_of(value);
    }
    return exact_orient3d(a, b, c, d);
}

namespace {

// The sign by double-doubles, or nothing where they do not decide: as where the points lie on a circle but for
// rounding. A monomial goes through seven operations after the exact differences: two in the lift, two in the minor, a
// product and two sums.
std::optional<int> in_circle_in_double_doubles(const std::array<const Vec2*, 3>& corners, const Vec2& d) {
    std::array<DoubleDouble, 3> x;
    std::array<DoubleDouble, 3> y;
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = DoubleDouble::difference(corners[i]->x(), d.x());
        y[i] = DoubleDouble::difference(corners[i]->y(), d.y());
    }
    DoubleDouble value;
    double magnitude = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        const DoubleDouble lift = x[i] * x[i] + y[i] * y[i];
        value = value + lift * (x[j] * y[k] - x[k] * y[j]);
        magnitude += lift.high * (std::abs(x[j].high * y[k].high) + std::abs(x[k].high * y[j].high));
    }
    const double bound = 10.0 * 15.0 * 0x1p-106 * magnitude;
    return std::abs(value.high) >= bound && value.high != 0.0 ? std::optional(sign_of(value.high)) : std::nullopt;
}

int exact_in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    if (const std::optional<int> sign = in_circle_in_double_doubles({&a, &b, &c}, d)) {
        return *sign;
    }
    std::array<Expansion, 3> x;
    std::array<Expansion, 3> y;
    std::array<Expansion, 3> lift;
    const std::array<const Vec2*, 3> corners{&a, &b, &c};
    for (int i = 0; i < 3; ++i) {
        x[i] = Expansion::difference(corners[i]->x(), d.x());
        y[i] = Expansion::difference(corners[i]->y(), d.y());
        lift[i] = x[i] * x[i] + y[i] * y[i];
    }
    Expansion sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        sum = sum + lift[i] * (x[j] * y[k] - x[k] * y[j]);
    }
    return sum.sign();
}

}  // namespace

// The determinant of the rows (x, y, x^2 + y^2) relative to d. A monomial takes four operations in the lift (two
// differences, a product, a sum), four in the minor, one for their product, and two sums: 11.
int in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const Vec2 da = a - d;
    const Vec2 db = b - d;
    const Vec2 dc = c - d;
    const double bc = db.x() * dc.y();
    const double cb = dc.x() * db.y();
    const double ca = dc.x() * da.y();
    const double ac = da.x() * dc.y();
    const double ab = da.x() * db.y();
    const double ba = db.x() * da.y();
    const double a_lift = da.x() * da.x() + da.y() * da.y();
    const double b_lift = db.x() * db.x() + db.y() * db.y();
    const double c_lift = dc.x() * dc.x() + dc.y() * dc.y();
    const double value = a_lift * (bc - cb) + b_lift * (ca - ac) + c_lift * (ab - ba);
    const double magnitude = a_lift * (std::abs(bc) + std::abs(cb)) + b_lift * (std::abs(ca) + std::abs(ac)) +
                             c_lift * (std::abs(ab) + std::abs(ba));
    if (settled(std::abs(value) >= rounding_bound(11) * magnitude)) {
        return sign_of(value);
    }
    return exact_in_circle(a, b, c, d);
}

namespace {

/// The minors of the rows of x and y, from which in_sphere computes its determinant.
struct SphereMinors {
    double ab, bc, cd, da, ac, bd;
};

/// The sign by double-doubles, or nothing where they do not decide. A monomial goes through eleven operations after the
/// exact differences: two in the minor, three to that of three rows, three in the lift, a product and two sums. The
/// determinant is a multiple of the product of the lowest bits of the coordinates and the square of the lowest of all.
std::optional<int> in_sphere_in_double_doubles(const std::array<const Vec3*, 4>& corners, const Vec3& e) {
    DoubleDouble value;
    double magnitude = 0.0;
    std::array<DoubleDoubleVec, 4> d;
    for (std::size_t i = 0; i < 4; ++i) {
        d[i] = difference(*corners[i], e);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const DoubleDoubleVec& p = d[(i + 1) % 4];
        const DoubleDoubleVec& q = d[(i + 2) % 4];
        const DoubleDoubleVec& r = d[(i + 3) % 4];
        const DoubleDouble term = dot(d[i], d[i]) * dot(p, cross(q, r));
        value = i % 2 == 0 ? value + term : value - term;
        magnitude +=
            magnitudes(d[i]).squaredNorm() * magnitudes(p).dot(cross_of_magnitudes(magnitudes(q), magnitudes(r)));
    }
    const double bound = 14.0 * 15.0 * 0x1p-106 * magnitude;
    if (std::abs(value.high) >= bound && value.high != 0.0) {
        return sign_of(value.high);
    }
    int unit = 0;
    int lowest = std::numeric_limits<double>::max_exponent;
    for (int i = 0; i < 3; ++i) {
        const int bit = lowest_bit({(*corners[0])[i], (*corners[1])[i], (*corners[2])[i], (*corners[3])[i], e[i]});
        unit += bit;
        lowest = std::min(lowest, bit);
    }
    return std::abs(value.high) + 2.0 * bound < std::ldexp(1.0, unit + 2 * lowest) ? std::optional(0) : std::nullopt;
}

int exact_in_sphere(const std::array<const Vec3*, 4>& corners, const Vec3& e) {
    if (const std::optional<int> sign = in_sphere_in_double_doubles(corners, e)) {
        return *sign;
    }
    std::array<ExactVec, 4> d;
    for (std::size_t i = 0; i < 4; ++i) {
        d[i] = exact_difference(*corners[i], e);
    }
    Expansion sum;
    for (std::size_t i = 0; i < 4; ++i) {
        const ExactVec& p = d[(i + 1) % 4];
        const ExactVec& q = d[(i + 2) % 4];
        const ExactVec& r = d[(i + 3) % 4];
        const ExactVec normal{(q[1] * r[2] - q[2] * r[1]).compressed(), (q[2] * r[0] - q[0] * r[2]).compressed(),
                              (q[0] * r[1] - q[1] * r[0]).compressed()};
        const Expansion term = exact_dot(d[i], d[i]).compressed() * exact_dot(p, normal).compressed();
        sum = i % 2 == 0 ? sum + term : sum - term;
    }
    return sum.sign();
}

}  // namespace

// The determinant of the rows (x, y, z, x^2 + y^2 + z^2) relative to e, as four products of a lift and a minor of three
// rows. A monomial takes five operations in the lift (two differences, a product, two sums), eight in the minor (as in
// orient3d), one for their product, and two sums: 16.
int in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
    const std::array<Vec3, 4> r{a - e, b - e, c - e, d - e};
    const auto minor = [&](std::size_t i, std::size_t k) { return r[i].x() * r[k].y() - r[k].x() * r[i].y(); };
    const auto size = [&](std::size_t i, std::size_t k) {
        return std::abs(r[i].x() * r[k].y()) + std::abs(r[k].x() * r[i].y());
    };
    const SphereMinors m{minor(0, 1), minor(1, 2), minor(2, 3), minor(3, 0), minor(0, 2), minor(1, 3)};
    const SphereMinors s{size(0, 1), size(1, 2), size(2, 3), size(3, 0), size(0, 2), size(1, 3)};
    const std::array<double, 4> lift{r[0].squaredNorm(), r[1].squaredNorm(), r[2].squaredNorm(), r[3].squaredNorm()};
    const std::array<double, 4> z{std::abs(r[0].z()), std::abs(r[1].z()), std::abs(r[2].z()), std::abs(r[3].z())};
    const double bcd = r[1].z() * m.cd - r[2].z() * m.bd + r[3].z() * m.bc;
    const double cda = r[2].z() * m.da + r[3].z() * m.ac + r[0].z() * m.cd;
    const double dab = r[3].z() * m.ab + r[0].z() * m.bd + r[1].z() * m.da;
    const double abc = r[0].z() * m.bc - r[1].z() * m.ac + r[2].z() * m.ab;
    const double value = (lift[0] * bcd - lift[1] * cda) + (lift[2] * dab - lift[3] * abc);
    const double magnitude =
        lift[0] * (z[1] * s.cd + z[2] * s.bd + z[3] * s.bc) + lift[1] * (z[2] * s.da + z[3] * s.ac + z[0] * s.cd) +
        lift[2] * (z[3] * s.ab + z[0] * s.bd + z[1] * s.da) + lift[3] * (z[0] * s.bc + z[1] * s.ac + z[2] * s.ab);
    if (settled(std::abs(value) >= rounding_bound(17) * magnitude)) {
        return sign_of(value);
    }
    return exact_in_sphere({&a, &b, &c, &d}, e);
}

}  // namespace mq

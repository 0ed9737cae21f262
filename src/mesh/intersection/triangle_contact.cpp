// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/triangle_contact.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/predicates.h"

namespace mq::mesh {
namespace {

using Corners = std::array<const Vec3*, 3>;
using Signs = std::array<int, 3>;

Corners corners_of(const std::vector<Vec3>& vertices, const Triangle& t) {
    return {&vertices[t[0]], &vertices[t[1]], &vertices[t[2]]};
}

bool is_degenerate(const Corners& t) {
    return collinear(*t[0], *t[1], *t[2]);
}

bool one_sided(const Signs& s) {
    return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
}

bool all_zero(const Signs& s) {
    return s[0] == 0 && s[1] == 0 && s[2] == 0;
}

bool straddles(const Signs& s) {
    const auto [low, high] = std::minmax_element(s.begin(), s.end());
    return *low < 0 && *high > 0;
}

// ---- in the plane ---------------------------------------------------------------------------------------------------

/// A projection along an axis in which triangles of one plane do not collapse, seen from the side on which `t` runs
/// counter-clockwise.
class Projection {
  public:
    /// `t` is not degenerate.
    explicit Projection(const Corners& t) {
        for (int axis = 0; axis < 3; ++axis) {
            x_ = (axis + 1) % 3;
            y_ = (axis + 2) % 3;
            const int sign = side(*t[0], *t[1], *t[2]);
            if (sign != 0) {
                if (sign < 0) {
                    std::swap(x_, y_);
                }
                return;
            }
        }
    }
    /// Positive when c lies to the left of a-b.
    int side(const Vec3& a, const Vec3& b, const Vec3& c) const {
        return orient2d(Vec2(a[x_], a[y_]), Vec2(b[x_], b[y_]), Vec2(c[x_], c[y_]));
    }
    int max_side(const Vec3& a, const Vec3& b, const Corners& t) const {
        return std::max({side(a, b, *t[0]), side(a, b, *t[1]), side(a, b, *t[2])});
    }

  private:
    int x_ = 0;
    int y_ = 1;
};

/// Separating axes of two convex polygons: the edges' normals suffice.
Contact contact_in_plane(const Corners& p, Corners q) {
    const Projection plane(p);
    if (plane.side(*q[0], *q[1], *q[2]) < 0) {
        std::swap(q[1], q[2]);
    }
    int gap = 1;
    for (int i = 0; i < 3; ++i) {
        gap = std::min(gap, plane.max_side(*p[i], *p[(i + 1) % 3], q));
        gap = std::min(gap, plane.max_side(*q[i], *q[(i + 1) % 3], p));
    }
    return gap > 0 ? Contact::Crossing : gap == 0 ? Contact::Touching : Contact::None;
}

/// A segment of the plane of t has points of t.
bool segment_meets_in_plane(const Vec3& a, const Vec3& b, const Corners& t) {
    const Projection plane(t);
    for (int i = 0; i < 3; ++i) {
        const Vec3& c = *t[i];
        const Vec3& d = *t[(i + 1) % 3];
        if (plane.side(c, d, a) < 0 && plane.side(c, d, b) < 0) {
            return false;
        }
    }
    return plane.max_side(a, b, t) >= 0 && plane.max_side(b, a, t) >= 0;
}

// ---- in space -------------------------------------------------------------------------------------------------------

/// The segment a-b, its ends on the sides a_sign and b_sign of the plane of t, has points of t.
bool segment_meets(const Vec3& a, int a_sign, const Vec3& b, int b_sign, const Corners& t) {
    if (a_sign * b_sign > 0) {
        return false;
    }
    if (a_sign == 0 && b_sign == 0) {
        return segment_meets_in_plane(a, b, t);
    }
    int low = 1;
    int high = -1;
    for (int i = 0; i < 3; ++i) {
        const int sign = orient3d(a, b, *t[i], *t[(i + 1) % 3]);
        low = std::min(low, sign);
        high = std::max(high, sign);
    }
    return low >= 0 || high <= 0;
}

/// Rotates the corners of a triangle that straddles a plane so that its first corner is alone on its side.
void put_lone_corner_first(Corners& t, Signs& s) {
    int lone = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        if (s[i] != 0 && s[j] != s[i] && s[k] != s[i]) {
            lone = i;
        }
    }
    std::rotate(t.begin(), t.begin() + lone, t.end());
    std::rotate(s.begin(), s.begin() + lone, s.end());
}

/// The interiors of two triangles that straddle each other's planes meet: the open intervals in which they cut the
/// common line overlap. The ends of an interval are compared by the sides on which edges pass each other.
bool interiors_meet(Corners p, Signs p_signs, Corners q, Signs q_signs) {
    put_lone_corner_first(p, p_signs);
    put_lone_corner_first(q, q_signs);
    if (p_signs[0] < 0) {
        std::swap(q[1], q[2]);
    }
    if (q_signs[0] < 0) {
        std::swap(p[1], p[2]);
    }
    return orient3d(*p[0], *p[1], *q[0], *q[1]) < 0 && orient3d(*p[0], *p[2], *q[2], *q[0]) < 0;
}

/// Moves the common corners to the front, in the same order. Returns how many there are.
int align(Triangle& p, Triangle& q) {
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = shared; j < 3; ++j) {
            if (p[i] == q[j]) {
                std::swap(p[shared], p[i]);
                std::swap(q[shared], q[j]);
                ++shared;
                break;
            }
        }
    }
    return shared;
}

/// The sides of p's corners relative to the plane of q; the first `shared` corners lie in it.
Signs sides_of(const Corners& p, const Corners& q, int shared) {
    Signs signs{0, 0, 0};
    for (int i = shared; i < 3; ++i) {
        signs[i] = orient3d(*q[0], *q[1], *q[2], *p[i]);
    }
    return signs;
}

/// The contact of triangles in one plane with `shared` < 3 common corners.
Contact contact_when_coplanar(const Corners& p, const Corners& q, int shared) {
    if (shared == 2) {
        const Projection plane(p);
        return plane.side(*p[0], *p[1], *q[2]) > 0 ? Contact::Crossing : Contact::None;
    }
    const Contact found = contact_in_plane(p, q);
    if (shared == 0 || found != Contact::Touching) {
        return found;
    }
    const bool elsewhere = segment_meets_in_plane(*p[1], *p[2], q) || segment_meets_in_plane(*q[1], *q[2], p);
    return elsewhere ? Contact::Touching : Contact::None;
}

/// Whether all corners of one triangle are farther along a direction than those of the other one. A sum of three
/// products has an error of less than 4 unit roundoffs by its magnitudes; epsilon is two of them.
bool parts(const Vec3& way, const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& q) {
    constexpr double kMargin = 4.0 * std::numeric_limits<double>::epsilon();
    const Vec3 size = way.cwiseAbs();
    std::array<double, 3> of_p{};
    std::array<double, 3> of_q{};
    double largest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        of_p[k] = way.dot(p[k]);
        of_q[k] = way.dot(q[k]);
        largest = std::max({largest, size.dot(p[k].cwiseAbs()), size.dot(q[k].cwiseAbs())});
    }
    const auto [low_p, high_p] = std::minmax({of_p[0], of_p[1], of_p[2]});
    const auto [low_q, high_q] = std::minmax({of_q[0], of_q[1], of_q[2]});
    return std::max(low_p - high_q, low_q - high_p) > kMargin * largest;
}

/// p has an edge that meets q. Where a corner is shared only the edge opposite is tested: other common points begin at
/// the corner and end on such an edge of one or the other.
bool edge_meets(const Corners& p, const Signs& p_signs, const Corners& q, int shared) {
    for (int i = shared; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (j >= shared && segment_meets(*p[i], p_signs[i], *p[j], p_signs[j], q)) {
            return true;
        }
    }
    return false;
}

}  // namespace

Contact contact(const std::vector<Vec3>& vertices, const Triangle& first, const Triangle& second) {
    Triangle a = first;
    Triangle b = second;
    const int shared = align(a, b);
    const Corners p = corners_of(vertices, a);
    const Corners q = corners_of(vertices, b);
    if (shared == 3) {
        return is_degenerate(p) ? Contact::None : Contact::Crossing;
    }
    const Signs p_signs = sides_of(p, q, shared);
    if (one_sided(p_signs)) {
        return Contact::None;
    }
    const Signs q_signs = sides_of(q, p, shared);
    if (one_sided(q_signs)) {
        return Contact::None;
    }
    if (all_zero(p_signs) || all_zero(q_signs)) {
        if (is_degenerate(p) || is_degenerate(q)) {
            return Contact::None;
        }
        return contact_when_coplanar(p, q, shared);
    }
    if (shared == 2) {
        return Contact::None;
    }
    if (straddles(p_signs) && straddles(q_signs) && interiors_meet(p, p_signs, q, q_signs)) {
        return Contact::Crossing;
    }
    return edge_meets(p, p_signs, q, shared) || edge_meets(q, q_signs, p, shared) ? Contact::Touching : Contact::None;
}

bool certainly_apart(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& q) {
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    if (parts(normal, p, q)) {
        return true;
    }
    for (const std::array<Vec3, 3>* t : {&p, &q}) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (parts(normal.cross((*t)[(k + 1) % 3] - (*t)[k]), p, q)) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace mq::mesh

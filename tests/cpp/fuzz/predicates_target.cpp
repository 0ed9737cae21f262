// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Every predicate against its definition in rational arithmetic.
#include <array>

#include "base/exact.h"
#include "base/predicates.h"
#include "bytes.h"

namespace mq {
namespace {

/// Points of safe coordinates, of which some lie beside the one before; of any size.
std::array<Vec3, 4> points_of(fuzz::Bytes& bytes) {
    constexpr int kMostBits = 50;
    const double scale = std::ldexp(1.0, bytes.number(0, 1) > 0 ? bytes.number(-kMostBits, kMostBits) : 0);
    std::array<Vec3, 4> points;
    Vec3 before = Vec3::Zero();
    for (Vec3& p : points) {
        for (int i = 0; i < 3; ++i) {
            p[i] = bytes.near(before[i]);
        }
        before = p;
    }
    for (Vec3& p : points) {
        p = (scale * p).unaryExpr(&fuzz::Bytes::safe);
    }
    return points;
}

/// The last one on the line or the plane of the others, but for rounding.
void put_in_plane(std::array<Vec3, 4>& p, fuzz::Bytes& bytes) {
    const double s = bytes.part(-1.0, 2.0);
    const double t = bytes.part(-1.0, 2.0);
    p[3] = (p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0])).unaryExpr(&fuzz::Bytes::safe);
}

void compare(const std::array<Vec3, 4>& points) {
    const auto& [a, b, c, d] = points;
    fuzz::require(sign_dot(a, b, c) == exact::sign_dot(a, b, c), "sign_dot is exact");
    fuzz::require(encroached(a, b, c) == (exact::sign_dot(c, a, b) < 0), "encroached is exact");
    fuzz::require(collinear(a, b, c) == exact::collinear(a, b, c), "collinear is exact");
    fuzz::require(orient3d(a, b, c, d) == exact::orient3d(a, b, c, d), "orient3d is exact");
    fuzz::require(locally_maxmin(a, b, c, d) == exact::locally_maxmin(a, b, c, d), "locally_maxmin is exact");
    for (int axis = 0; axis < 3; ++axis) {
        const auto flat = [&](const Vec3& p) { return Vec2(p[(axis + 1) % 3], p[(axis + 2) % 3]); };
        const int turn = exact::orient2d(flat(a), flat(b), flat(c));
        fuzz::require(orient2d(flat(a), flat(b), flat(c)) == turn, "orient2d is exact");
        fuzz::require(orient2d(a, b, c, axis) == turn, "orient2d along an axis is exact");
        fuzz::require(
            in_circle(flat(a), flat(b), flat(c), flat(d)) == exact::in_circle(flat(a), flat(b), flat(c), flat(d)),
            "in_circle is exact");
    }
}

}  // namespace
}  // namespace mq

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    mq::fuzz::Bytes bytes(data, size);
    const bool in_plane = bytes.number(0, 1) > 0;
    std::array<mq::Vec3, 4> points = mq::points_of(bytes);
    if (in_plane) {
        mq::put_in_plane(points, bytes);
    }
    mq::compare(points);
    return 0;
}

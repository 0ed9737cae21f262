// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/triangle_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/predicates.h"
#include "boolean/near_coincidence/tuning.h"

namespace mq::boolean {

namespace {

/// A triangle clipped by half-spaces, each of which adds at most one corner.
class ConvexPolygon {
  public:
    explicit ConvexPolygon(const std::array<Vec3, 3>& triangle) : size_(3) {
        std::copy(triangle.begin(), triangle.end(), points_.begin());
    }

    /// Leaves the points with value(point) >= 0, a linear function (Sutherland and Hodgman 1974).
    template <typename Value>
    void clip(const Value& value) {
        std::array<double, kMostCorners> values;
        bool inside = true;
        for (std::size_t i = 0; i < size_; ++i) {
            values[i] = value(points_[i]);
            inside = inside && values[i] >= 0.0;
        }
        if (inside) {
            return;
        }
        std::array<Vec3, kMostCorners> whole;
        const std::size_t count = size_;
        std::copy(points_.begin(), points_.begin() + count, whole.begin());
        size_ = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t next = i + 1 < count ? i + 1 : 0;
            const Vec3& p = whole[i];
            const Vec3& q = whole[next];
            const double at_p = values[i];
            const double at_q = values[next];
            if (at_p >= 0.0) {
                add(p);
            }
            if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0)) {
                add(p + at_p / (at_p - at_q) * (q - p));
            }
        }
    }

    double area() const {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 2; i < size_; ++i) {
            sum += (points_[i - 1] - points_[0]).cross(points_[i] - points_[0]);
        }
        return 0.5 * sum.norm();
    }
    const Vec3* begin() const { return points_.data(); }
    const Vec3* end() const { return points_.data() + size_; }

  private:
    static constexpr std::size_t kMostCorners = 16;  // rounding may add some to 3 + 5 half-spaces

    void add(const Vec3& p) {
        if (size_ < kMostCorners) {
            points_[size_++] = p;
        }
    }

    std::array<Vec3, kMostCorners> points_;
    std::size_t size_ = 0;
};

bool in_one_plane(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& q) {
    return std::all_of(q.begin(), q.end(), [&](const Vec3& x) { return orient3d(p[0], p[1], p[2], x) == 0; });
}

}  // namespace

Overlap overlap_of(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& q, double reach, double margin) {
    Overlap result;
    const Vec3 m = (p[1] - p[0]).cross(p[2] - p[0]);
    const Vec3 n = (q[1] - q[0]).cross(q[2] - q[0]);
    const double cosine = m.dot(n);
    const double lengths = m.norm() * n.norm();
    if (!(std::abs(cosine) > NearCoincidenceTuning::kParallelPlanes * lengths)) {
        return result;
    }
    const Vec3 up = m.normalized();
    const auto height = [&](const Vec3& x) { return up.dot(x - p[0]); };
    const Vec3 heights(height(q[0]), height(q[1]), height(q[2]));
    if (heights.minCoeff() > reach || heights.maxCoeff() < -reach) {
        return result;
    }
    ConvexPolygon common(q);
    const Vec3 along = cosine > 0.0 ? n : Vec3(-n);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 inward = along.cross(p[(k + 1) % 3] - p[k]);
        const double farther = margin > 0.0 ? margin * inward.norm() : 0.0;
        common.clip([&](const Vec3& x) { return inward.dot(x - p[k]) + farther; });
        if (common.begin() == common.end()) {
            return result;
        }
    }
    result.low = std::numeric_limits<double>::infinity();
    result.high = -result.low;
    for (const Vec3& x : common) {
        result.low = std::min(result.low, height(x));
        result.high = std::max(result.high, height(x));
    }
    if (!(result.low <= reach && result.high >= -reach)) {
        return {};
    }
    common.clip([&](const Vec3& x) { return reach - height(x); });
    common.clip([&](const Vec3& x) { return reach + height(x); });
    result.area = common.area();
    // Triangles side by side overlap by rounding.
    constexpr double kAreaRounding = 1e-9;  // a fraction of the smaller triangle's area
    if (result.area <= kAreaRounding * std::min(m.norm(), n.norm())) {
        return {};
    }
    for (const Vec3& x : common) {
        result.box.add(x);
    }
    if (in_one_plane(p, q)) {
        result.low = result.high = 0.0;
    }
    result.same_side = cosine > 0.0;
    result.worst = std::min(reach, std::max(std::abs(result.low), std::abs(result.high)));
    return result;
}

}  // namespace mq::boolean

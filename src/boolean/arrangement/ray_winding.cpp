// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/ray_winding.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/error.h"
#include "base/predicates.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::boolean {

namespace {

/// A line along an axis through a point inside a face.
class AxisRay {
  public:
    AxisRay(const Soup& soup, const Arrangement& arrangement, std::int32_t face, int axis, const Vec3& through)
        : soup_(soup),
          arrangement_(arrangement),
          face_(arrangement.faces[static_cast<std::size_t>(face)]),
          axis_(axis),
          from_(through),
          to_(through) {
        from_[axis] = 0.0;
        to_[axis] = 1.0;
    }

    /// +1 or -1 as the face's normal points along the axis or against it; 0 when the line does not pass through its
    /// inside.
    int through_face() const {
        const PointTable& points = arrangement_.points;
        const ExactPoint p(from_);
        const ExactPoint a = points.at(face_.points[0]);
        const ExactPoint b = points.at(face_.points[1]);
        const ExactPoint c = points.at(face_.points[2]);
        const int side = orient2d(a, b, p, axis_);
        return side == orient2d(b, c, p, axis_) && side == orient2d(c, a, p, axis_) ? side : 0;
    }

    /// Windings where the ray leaves the face along the axis; nothing when it meets an edge, or another face in the
    /// same place.
    std::optional<std::vector<std::int32_t>> count() const {
        std::vector<std::int32_t> winding(static_cast<std::size_t>(soup_.operands), 0);
        const ExactPoint start = meet(face_.source);
        for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
            if (!near(soup_.triangles[t])) {
                continue;
            }
            const std::optional<int> side = pierced(soup_.triangles[t]);
            if (!side) {
                return std::nullopt;
            }
            if (*side == 0 || covers_face(static_cast<std::int32_t>(t))) {
                continue;
            }
            const int way = compare(meet(static_cast<std::int32_t>(t)), start, axis_);
            if (way == 0) {
                return std::nullopt;
            }
            if (way > 0) {
                winding[static_cast<std::size_t>(soup_.source[t].operand)] += *side;
            }
        }
        return winding;
    }

  private:
    ExactPoint meet(std::int32_t triangle) const {
        return ExactPoint::on_line(from_, to_, arrangement_.points.plane(triangle));
    }

    bool near(const Triangle& t) const {
        for (int k = 1; k <= 2; ++k) {
            const int i = (axis_ + k) % 3;
            const double a = at(t, 0)[i];
            const double b = at(t, 1)[i];
            const double c = at(t, 2)[i];
            if (std::min({a, b, c}) > from_[i] || std::max({a, b, c}) < from_[i]) {
                return false;
            }
        }
        return true;
    }

    const Vec3& at(const Triangle& t, std::size_t k) const { return soup_.vertices[static_cast<std::size_t>(t[k])]; }

    /// The sign of the triangle's normal along the axis, 0 when the line misses it; nothing when the line touches its
    /// border.
    std::optional<int> pierced(const Triangle& t) const {
        std::array<int, 3> side{};
        for (std::size_t k = 0; k < 3; ++k) {
            side[k] = mq::orient2d(at(t, k), at(t, (k + 1) % 3), from_, axis_);
        }
        const bool positive = side[0] > 0 || side[1] > 0 || side[2] > 0;
        const bool negative = side[0] < 0 || side[1] < 0 || side[2] < 0;
        if (positive && negative) {
            return 0;
        }
        if (side[0] == 0 || side[1] == 0 || side[2] == 0) {
            return std::nullopt;
        }
        return positive ? 1 : -1;
    }

    bool covers_face(std::int32_t t) const {
        if (face_.stack < 0) {
            return t == face_.source;
        }
        const std::vector<CoplanarCover>& stack = arrangement_.stacks[static_cast<std::size_t>(face_.stack)];
        return std::any_of(stack.begin(), stack.end(), [&](const CoplanarCover& cover) { return cover.triangle == t; });
    }

    const Soup& soup_;
    const Arrangement& arrangement_;
    const Face& face_;
    int axis_;
    Vec3 from_;
    Vec3 to_;
};

/// Windings behind a face from those in front of it, or the other way: the ray leaves the front only where the face
/// looks along the axis.
void pass_face(const Soup& soup, const Arrangement& arrangement, const Face& face, std::vector<std::int32_t>& winding) {
    const auto pass = [&](const CoplanarCover& cover) {
        winding[static_cast<std::size_t>(soup.source[static_cast<std::size_t>(cover.triangle)].operand)] -= cover.turn;
    };
    if (face.stack < 0) {
        pass({face.source, 1});
    } else {
        const std::vector<CoplanarCover>& stack = arrangement.stacks[static_cast<std::size_t>(face.stack)];
        std::for_each(stack.begin(), stack.end(), pass);
    }
}

}  // namespace

std::optional<RayWinding> winding_in_front(const Soup& soup, const Arrangement& arrangement,
                                           const std::vector<std::int32_t>& faces) {
    const PointTable& points = arrangement.points;
    const auto normal = [&](std::int32_t f) -> Vec3 {
        const Face& face = arrangement.faces[static_cast<std::size_t>(f)];
        const Vec3 a = points.approx(face.points[0]);
        return (points.approx(face.points[1]) - a).cross(points.approx(face.points[2]) - a);
    };
    // Faces tried, the largest first, before the search for a ray fails.
    constexpr std::size_t kMostFaces = 64;
    std::vector<std::pair<double, std::int32_t>> order;
    for (const std::int32_t f : faces) {
        order.emplace_back(-normal(f).cwiseAbs().maxCoeff(), f);
    }
    const auto most = static_cast<std::ptrdiff_t>(std::min(kMostFaces, order.size()));
    std::partial_sort(order.begin(), order.begin() + most, order.end());
    // Barycentric weights that are no simple fractions, so that rays seldom meet edges.
    constexpr double kWeights[][3] = {{0.3371, 0.3254, 0.3375}, {0.2713, 0.4191, 0.3096}, {0.4337, 0.2118, 0.3545}};
    bool has_inside = false;
    for (std::ptrdiff_t i = 0; i < most; ++i) {
        const std::int32_t f = order[static_cast<std::size_t>(i)].second;
        const Face& face = arrangement.faces[static_cast<std::size_t>(f)];
        int axis = 0;
        normal(f).cwiseAbs().maxCoeff(&axis);
        for (const double(&weight)[3] : kWeights) {
            const Vec3 through = weight[0] * points.approx(face.points[0]) + weight[1] * points.approx(face.points[1]) +
                                 weight[2] * points.approx(face.points[2]);
            const AxisRay ray(soup, arrangement, f, axis, through);
            const int side = ray.through_face();
            if (side == 0) {
                continue;
            }
            has_inside = true;
            if (auto winding = ray.count()) {
                if (side < 0) {
                    pass_face(soup, arrangement, face, *winding);
                }
                return RayWinding{f, std::move(*winding)};
            }
        }
    }
    if (!has_inside) {
        return std::nullopt;
    }
    throw TopologyError(phrases::kEnclosureNotDecided);
}

}  // namespace mq::boolean

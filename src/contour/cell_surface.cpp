// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/cell_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "contour/quadric.h"
#include "contour/tuning.h"

namespace mq::contour {

namespace {

using Corners = std::array<Vec3, 4>;
using Face = std::array<Vec3, 3>;

/// Whether the surface bends between two crossings more than a fan can follow.
bool is_bent(const Crossing& a, const Crossing& b) {
    return a.source >= 0 && b.source >= 0 && a.normal.dot(b.normal) < ContourTuning::kSharpCosine;
}

bool is_feature(const Crossing& a, const Crossing& b) {
    return is_bent(a, b) || a.patch != b.patch;
}

/// Barycentric coordinates of a point in a tetrahedron.
std::array<double, 4> barycentric(const Vec3& p, const Corners& c) {
    const auto volume = [](const Vec3& u, const Vec3& v, const Vec3& w, const Vec3& x) {
        return (v - u).cross(w - u).dot(x - u);
    };
    const double whole = volume(c[0], c[1], c[2], c[3]);
    return {volume(p, c[1], c[2], c[3]) / whole, volume(c[0], p, c[2], c[3]) / whole,
            volume(c[0], c[1], p, c[3]) / whole, volume(c[0], c[1], c[2], p) / whole};
}

/// The point itself if it is inside of the cell; else the last point inside on the segment from `middle` to it.
Vec3 kept_inside(const Vec3& point, const Vec3& middle, const Corners& corners) {
    const std::array<double, 4> there = barycentric(point, corners);
    const std::array<double, 4> here = barycentric(middle, corners);
    double share = 1.0;
    for (std::size_t k = 0; k < 4; ++k) {
        const double inset = std::min(ContourTuning::kInset, 0.5 * here[k]);
        if (there[k] < inset) {
            share = std::min(share, (here[k] - inset) / (here[k] - there[k]));
        }
    }
    return middle + share * (point - middle);
}

/// Moves a point towards the zero set of a level set as long as its value gets smaller. step(point, level) gives the
/// next point.
template <typename Step>
Vec3 projected(Vec3 point, const LevelSet& level_set, std::int32_t guess, const Step& step) {
    constexpr int kProjectionSteps = 3;
    LevelSample level = level_set.at(point, guess);
    for (int i = 0; i < kProjectionSteps && std::abs(level.value) > level_set.resolution(); ++i) {
        const Vec3 next = step(point, level);
        const LevelSample there = level_set.at(next, level.source);
        if (std::abs(there.value) >= std::abs(level.value)) {
            break;
        }
        point = next;
        level = there;
    }
    return point;
}

class CellBuilder {
  public:
    CellBuilder(const CrossedCell& cell, const std::vector<Crossing>& crossings, const LevelSet* level_set)
        : cell_(cell), crossings_(crossings), level_set_(level_set) {}

    CellSurface run() {
        CellSurface result;
        for (int i = 0; i < count(); ++i) {
            for (int j = i + 1; j < count(); ++j) {
                result.is_cone = result.is_cone || is_feature(at(i), at(j));
                result.is_sharp = result.is_sharp || is_sharp(at(i), at(j));
            }
        }
        if (!result.is_cone) {
            const auto length = [&](int a, int b) { return (at(a).point - at(b).point).squaredNorm(); };
            result.first = count() == 4 && length(1, 3) < length(0, 2) ? 1 : 0;
            result.apex = at(result.first).point;
            return result;
        }
        for (int k = 0; k < count(); ++k) {
            const auto slot = static_cast<std::size_t>(k);
            result.has_face_point[slot] = is_feature(at(k), at(k + 1));
            if (result.has_face_point[slot]) {
                result.face_points[slot] = face_point(k);
            }
        }
        result.apex = result.is_sharp ? sharp_apex() : middle_of_face_points(result);
        if (level_set_ != nullptr) {
            result.apex =
                projected(result.apex, *level_set_, at(0).source, [&](const Vec3& p, const LevelSample& level) {
                    return kept_inside(p - level.value * level.gradient, middle(), cell_.corners);
                });
        }
        return result;
    }

  private:
    int count() const { return cell_.polygon.count; }
    /// Whether an edge lies between two crossings: their normals differ more than on a ball of the least radius.
    bool is_sharp(const Crossing& a, const Crossing& b) const {
        constexpr double kMore = 1.05;  // margin for rounding errors, and for chords instead of arcs
        return is_bent(a, b) && (level_set_ == nullptr || level_set_->least_radius() * (a.normal - b.normal).norm() >
                                                              kMore * (a.point - b.point).norm());
    }
    const Crossing& at(int k) const {
        return crossings_[static_cast<std::size_t>(cell_.crossings[static_cast<std::size_t>(k % count())])];
    }
    Vec3 middle() const {
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < count(); ++k) {
            sum += at(k).point / count();
        }
        return sum;
    }

    Vec3 sharp_apex() const {
        Quadric planes;
        for (int k = 0; k < count(); ++k) {
            planes.add_plane(at(k).on_input, at(k).normal, 1.0);
        }
        return kept_inside(planes.least(middle(), ContourTuning::kFlatShare), middle(), cell_.corners);
    }
    /// The middle of the points on faces, at which the border between patches enters and leaves the cell.
    Vec3 middle_of_face_points(const CellSurface& surface) const {
        Vec3 sum = Vec3::Zero();
        double points = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            if (surface.has_face_point[k]) {
                sum += surface.face_points[k];
                points += 1.0;
            }
        }
        return points > 0.0 ? kept_inside(sum / points, middle(), cell_.corners) : middle();
    }

    /// The point on the face between crossing k and the next one. Both cells of the face compute the same point:
    /// crossings are taken in the order of their indices.
    Vec3 face_point(int k) const {
        const std::array<std::size_t, 3> corners = face_between(cell_.polygon, k);
        const Face face{cell_.corners[corners[0]], cell_.corners[corners[1]], cell_.corners[corners[2]]};
        const bool in_order =
            cell_.crossings[static_cast<std::size_t>(k)] < cell_.crossings[static_cast<std::size_t>((k + 1) % count())];
        const Crossing& a = in_order ? at(k) : at(k + 1);
        const Crossing& b = in_order ? at(k + 1) : at(k);
        const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
        const Vec3 half = 0.5 * (a.point + b.point);
        Vec3 point = half;
        if (is_sharp(a, b)) {
            point = meeting(a, b, normal);
        } else if (a.patch != b.patch && level_set_ != nullptr) {
            point = border(a, b);
        }
        point = is_on(point, face, normal) ? point : half;
        if (level_set_ == nullptr) {
            return point;
        }
        return projected(point, *level_set_, a.source, [&](const Vec3& p, const LevelSample& level) {
            const Vec3 along = level.gradient - normal * normal.dot(level.gradient);
            const Vec3 next = p - along * (level.value / std::max(along.squaredNorm(), 1e-2));
            return is_on(next, face, normal) ? next : p;
        });
    }
    /// The intersection of the planes of two crossings with that of a face; the middle of the crossings if there is
    /// none.
    static Vec3 meeting(const Crossing& a, const Crossing& b, const Vec3& normal) {
        const Vec3 along = normal.cross(a.normal);
        const double turn = along.dot(b.normal);
        if (std::abs(turn) < 1e-6) {
            return 0.5 * (a.point + b.point);
        }
        return a.point + along * ((b.point - a.point).dot(b.normal) / turn);
    }
    /// The point between two crossings at which the patch changes.
    Vec3 border(const Crossing& a, const Crossing& b) const {
        constexpr int kHalvings = 10;
        Vec3 from = a.point;
        Vec3 to = b.point;
        std::int32_t guess = a.source;
        for (int i = 0; i < kHalvings; ++i) {
            const Vec3 half = 0.5 * (from + to);
            guess = level_set_->at(half, guess).source;
            (level_set_->patch(guess) == a.patch ? from : to) = half;
        }
        return 0.5 * (from + to);
    }
    static bool is_on(const Vec3& point, const Face& face, const Vec3& normal) {
        const double area = (face[1] - face[0]).cross(face[2] - face[0]).dot(normal);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& u = face[(k + 1) % 3];
            const Vec3& v = face[(k + 2) % 3];
            if ((u - point).cross(v - point).dot(normal) < ContourTuning::kInset * area) {
                return false;
            }
        }
        return true;
    }

    const CrossedCell& cell_;
    const std::vector<Crossing>& crossings_;
    const LevelSet* level_set_;
};

}  // namespace

std::array<std::size_t, 3> face_between(const CellPolygon& polygon, int k) {
    std::array<bool, 4> is_on{};
    for (const int edge : {k, (k + 1) % polygon.count}) {
        for (const std::int8_t corner : polygon.edges[static_cast<std::size_t>(edge)]) {
            is_on[static_cast<std::size_t>(corner)] = true;
        }
    }
    std::array<std::size_t, 3> face{};
    std::size_t found = 0;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        if (is_on[corner]) {
            face[found++] = corner;
        }
    }
    return face;
}

CellSurface cell_surface(const CrossedCell& cell, const std::vector<Crossing>& crossings, const LevelSet* level_set) {
    return CellBuilder(cell, crossings, level_set).run();
}

}  // namespace mq::contour

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "geometry/occt/conversion.h"
#include "geometry/occt/face_evaluator.h"
#include "geometry/occt/live_shape.h"

namespace mq::geometry {

namespace {

/// On these no coordinate has a peak within a face: it grows along a straight line towards an edge.
bool is_ruled(const ElementarySurface& surface) {
    using Kind = ElementarySurface::Kind;
    return surface.kind == Kind::Plane || surface.kind == Kind::Cylinder || surface.kind == Kind::Cone;
}

}  // namespace

/// Of the grid of samples, in the shape's coordinates.
Vec3 FaceEvaluator::placed_sample(int i, int k) const {
    const Vec3& p = grid_[static_cast<std::size_t>(i * (samples_[1] + 1) + k)];
    return located_ ? to_vec(to_pnt(p).Transformed(location_)) : p;
}

/// Peaks of the coordinates inside the face. Outside of it they do not count; what is highest inside then is on an
/// edge, or another peak.
void FaceEvaluator::add_to(Box& box) {
    if (elementary_ && is_ruled(*elementary_)) {
        return;
    }
    if (grid_.empty()) {
        sample();
    }
    for (int i = 0; i <= samples_[0]; ++i) {
        for (int k = 0; k <= samples_[1]; ++k) {
            for (int way = 0; way < 6; ++way) {
                search_peak(i, k, way / 2, way % 2 == 0 ? 1.0 : -1.0, box);
            }
        }
    }
}

/// Around a sample that none beside it beats, where a peak there may reach out of the box.
void FaceEvaluator::search_peak(int i, int k, int axis, double sign, Box& box) {
    const double bound = sign > 0.0 ? box.high[axis] : -box.low[axis];
    Vec3 best = placed_sample(i, k);
    const auto value = [&](int a, int b) { return sign * placed_sample(a, b)[axis]; };
    const double here = sign * best[axis];
    if ((i > 0 && here < value(i - 1, k)) || (i < samples_[0] && here < value(i + 1, k)) ||
        (k > 0 && here < value(i, k - 1)) || (k < samples_[1] && here < value(i, k + 1))) {
        return;
    }
    const int a = std::clamp(i, 1, samples_[0] - 1);
    const int b = std::clamp(k, 1, samples_[1] - 1);
    if (here + rise_over_sample(value(a - 1, k), value(a, k), value(a + 1, k)) +
            rise_over_sample(value(i, b - 1), value(i, b), value(i, b + 1)) <=
        bound) {
        return;
    }
    constexpr double kEnd = 1e-3;  // what is left is of the order of its square
    constexpr int kSteps = 200;
    const Vec2 cell((trimmed_.high[0] - trimmed_.low[0]) / samples_[0],
                    (trimmed_.high[1] - trimmed_.low[1]) / samples_[1]);
    Vec2 at = sample_at(i, k);
    double part = 0.5;
    for (int step = 0; step < kSteps && part > kEnd; ++step) {
        bool better = false;
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            Vec2 next = at + part * cell.cwiseProduct(way);
            next.x() = std::clamp(next.x(), trimmed_.low[0], trimmed_.high[0]);
            next.y() = std::clamp(next.y(), trimmed_.low[1], trimmed_.high[1]);
            const Vec3 p = placed(first(next.x(), next.y())).point;
            if (sign * p[axis] > sign * best[axis]) {
                best = p;
                at = next;
                better = true;
            }
        }
        part *= better ? 1.0 : 0.5;
    }
    if (sign * best[axis] > bound && contains(at.x(), at.y()).side >= 0) {
        box.add(best);
    }
}

}  // namespace mq::geometry

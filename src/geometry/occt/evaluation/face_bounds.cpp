// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/face_evaluator.h"

namespace mq::geometry {

namespace {

/// Surfaces on which no coordinate has a peak within a face: it grows along a straight line towards an edge.
bool is_ruled(const ElementarySurface& surface) {
    using Kind = ElementarySurface::Kind;
    return surface.kind == Kind::Plane || surface.kind == Kind::Cylinder || surface.kind == Kind::Cone;
}

}  // namespace

/// Adds the peaks of the coordinates inside the face. Peaks outside of it are ignored; the highest point inside is then
/// on an edge, or at another peak.
void FaceEvaluator::add_to(Box& box) {
    if (elementary_ && is_ruled(*elementary_)) {
        return;
    }
    if (grid_.empty()) {
        sample();
    }
    std::vector<Vec3> points = grid_;
    for (Vec3& p : points) {
        p = located_ ? to_vec(to_pnt(p).Transformed(location_)) : p;
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            std::vector<double> values;
            values.reserve(points.size());
            for (const Vec3& p : points) {
                values.push_back(sign * p[axis]);
            }
            for (const std::pair<int, int>& at :
                 samples_at_peaks(values, sign > 0.0 ? box.high[axis] : -box.low[axis])) {
                search_peak(at.first, at.second, axis, sign, box);
            }
        }
    }
}

/// The samples that are higher than all their neighbours, where the values may rise over `bound` between them.
std::vector<std::pair<int, int>> FaceEvaluator::samples_at_peaks(const std::vector<double>& values,
                                                                 double bound) const {
    const int rows = samples_[0];
    const int columns = samples_[1];
    const auto value = [&](int i, int k) { return values[static_cast<std::size_t>(i * (columns + 1) + k)]; };
    std::vector<std::pair<int, int>> found;
    for (int i = 0; i <= rows; ++i) {
        for (int k = 0; k <= columns; ++k) {
            const double here = value(i, k);
            if ((i > 0 && here < value(i - 1, k)) || (i < rows && here < value(i + 1, k)) ||
                (k > 0 && here < value(i, k - 1)) || (k < columns && here < value(i, k + 1))) {
                continue;
            }
            const int a = std::clamp(i, 1, rows - 1);
            const int b = std::clamp(k, 1, columns - 1);
            if (here + rise_over_sample(value(a - 1, k), value(a, k), value(a + 1, k)) +
                    rise_over_sample(value(i, b - 1), value(i, b), value(i, b + 1)) >
                bound) {
                found.emplace_back(i, k);
            }
        }
    }
    return found;
}

/// Searches a peak around a sample.
void FaceEvaluator::search_peak(int i, int k, int axis, double sign, Box& box) {
    // Relative step at which the search ends: the remaining error is of the order of its square.
    constexpr double kEnd = 1e-3;
    // Steps at most, so that the search ends on degenerate surfaces.
    constexpr int kPatternSteps = 200;
    // Least rise, as a fraction of the face's size; a smaller one is due to rounding, as on the ridge of a cylinder.
    constexpr double kAnything = 1e-8;
    const Vec2 cell((trimmed_.high[0] - trimmed_.low[0]) / samples_[0],
                    (trimmed_.high[1] - trimmed_.low[1]) / samples_[1]);
    const auto point = [&](const Vec2& uv) { return placed(first(uv.x(), uv.y())).point; };
    const double bound = sign > 0.0 ? box.high[axis] : -box.low[axis];
    Vec2 at = sample_at(i, k);
    Vec3 best = point(at);
    double part = 0.5;
    for (int step = 0; step < kPatternSteps && part > kEnd; ++step) {
        bool better = false;
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            Vec2 next = at + part * cell.cwiseProduct(way);
            next.x() = std::clamp(next.x(), trimmed_.low[0], trimmed_.high[0]);
            next.y() = std::clamp(next.y(), trimmed_.low[1], trimmed_.high[1]);
            const Vec3 p = next == at ? best : point(next);
            if (sign * p[axis] > sign * best[axis]) {
                best = p;
                at = next;
                better = true;
            }
        }
        part *= better ? 1.0 : 0.5;
    }
    const double more = kAnything * size_;
    if (sign * best[axis] > bound + more && contains(at.x(), at.y(), 0.0).side >= 0) {
        box.add(best);
    }
}

}  // namespace mq::geometry

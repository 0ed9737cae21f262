// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>
#include <vector>

#include "geometry/elementary/surface.h"
#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/edge_evaluator.h"

namespace mq::geometry {

namespace {

/// Radians in a turn.
constexpr double kTwoPi = 6.283185307179586476925286766559;

}  // namespace

/// `point` is in the curve's own coordinates. @returns whether t is a minimum of the distance in [low, high].
bool EdgeEvaluator::newton(const Vec3& point, double low, double high, double& t) const {
    // Newton steps at most; each about squares the distance near the minimum.
    constexpr int kNewtonSteps = 20;
    // Where the derivative of a curve nearly vanishes, as at ends with two poles in one place, the length of a step in
    // t is meaningless.
    const double still = 1e-9 * size_ / std::max(t1_ - t0_, 1e-300);
    double best = -1.0;
    for (int i = 0; i < kNewtonSteps; ++i) {
        const CurvePoint c = second(t);
        const Vec3 r = c.point - point;
        const double square = r.squaredNorm();
        if (best >= 0.0 && square > best * (1.0 + 1e-9) + 1e-24) {
            return false;
        }
        best = square;
        const double gradient = r.dot(c.first);
        const double speed2 = c.first.squaredNorm();
        const double curvature = speed2 + r.dot(c.second);
        if (!(speed2 > still * still)) {
            return false;
        }
        const double step = -gradient / (curvature > 0.1 * speed2 ? curvature : speed2);
        const double next = std::clamp(t + step, low, high);
        const double moved = std::abs(next - t) * std::sqrt(speed2);
        t = next;
        if (moved <= 1e-10 * size_) {
            return curvature > 0.0 || next == low || next == high;
        }
    }
    return false;
}

/// The best of many samples, improved by golden section search.
double EdgeEvaluator::nearest_sampled(const Vec3& point, double low, double high) const {
    const int count = 32 + 4 * static_cast<int>(knots_.size());
    const double step = (high - low) / count;
    const auto distance = [&](double t) { return (value(t) - point).squaredNorm(); };
    int best = 0;
    double least = distance(low);
    for (int i = 1; i <= count; ++i) {
        const double d = distance(low + i * step);
        if (d < least) {
            least = d;
            best = i;
        }
    }
    double t = low + best * step;
    double a = std::max(low, t - step);
    double b = std::min(high, t + step);
    if (newton(point, a, b, t)) {
        return t;
    }
    // The golden ratio less one: each step keeps this fraction of the interval.
    constexpr double kGolden = 0.6180339887498949;
    // Steps at most: the interval shrinks below double precision.
    constexpr int kSectionSteps = 80;
    for (int i = 0; i < kSectionSteps; ++i) {
        const double x = b - kGolden * (b - a);
        const double y = a + kGolden * (b - a);
        (distance(x) < distance(y) ? b : a) = distance(x) < distance(y) ? y : x;
    }
    t = 0.5 * (a + b);
    for (const double end : {low, high}) {
        if (distance(end) < distance(t)) {
            t = end;
        }
    }
    return t;
}

double EdgeEvaluator::nearest_on_circle(const Vec3& point, double guess, double low, double high) const {
    const gp_Ax2 frame = curve_->Circle().Position();
    const gp_Vec d(frame.Location(), to_pnt(point));
    const double x = d.Dot(frame.XDirection());
    const double y = d.Dot(frame.YDirection());
    if (std::hypot(x, y) <= 1e-14 * curve_->Circle().Radius()) {
        return std::clamp(guess, low, high);
    }
    const double t = branch_nearest(std::atan2(y, x), guess, kTwoPi);
    if (t >= low && t <= high) {
        return t;
    }
    // Another turn may lie in the range; otherwise the nearer end is taken.
    return std::clamp(branch_nearest(t, 0.5 * (low + high), kTwoPi), low, high);
}

Answer EdgeEvaluator::nearest(const Vec3& point, double guess, double low, double high) const {
    Answer answer;
    if (low <= high && (over_end(low) || over_end(high))) {
        return nearest_over_end(point, guess, low, high);
    }
    if (!in_range(low) || !in_range(high) || !(low <= high)) {
        answer.status = Status::BadQuery;
        return answer;
    }
    const double a = std::clamp(low, t0_, t1_);
    const double b = std::clamp(high, t0_, t1_);
    Vec3 local = point;
    if (located_) {
        local = to_vec(to_pnt(point).Transformed(location_.Inverted()));
    }
    double t = std::clamp(guess, a, b);
    const std::optional<double> found = native_ ? native_nearest(local, t, a, b) : std::nullopt;
    if (found) {
        t = *found;
    } else if (kind_ == Kind::Line) {
        const gp_Lin line = curve_->Line();
        t = std::clamp(gp_Vec(line.Location(), to_pnt(local)).Dot(gp_Vec(line.Direction())), a, b);
    } else if (kind_ == Kind::Circle) {
        t = nearest_on_circle(local, t, a, b);
    } else if (!newton(local, a, b, t)) {
        t = nearest_sampled(local, a, b);
    }
    answer = at_parameter(t);
    answer.distance = (answer.point - point).norm();
    return answer;
}

Answer EdgeEvaluator::nearest_of_all(const Vec3& point, double low, double high) const {
    // Each turn has several samples.
    const int count = kind_ == Kind::Other ? 32 + 8 * static_cast<int>(knots_.size()) : 1;
    const auto parameter = [&](int i) { return low + (high - low) * i / count; };
    std::vector<double> distances;
    for (int i = 0; i <= count; ++i) {
        distances.push_back((at(parameter(i)) - point).squaredNorm());
    }
    Answer best;
    for (int i = 0; i <= count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if ((i > 0 && distances[k - 1] < distances[k]) || (i < count && distances[k + 1] < distances[k])) {
            continue;
        }
        const Answer found =
            nearest(point, parameter(i), parameter(std::max(i - 1, 0)), parameter(std::min(i + 1, count)));
        best = found.found() && (!best.found() || found.distance < best.distance) ? found : best;
    }
    return best;
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include "geometry/closed_edge.h"
#include "geometry/occt/evaluation/edge_evaluator.h"

namespace mq::geometry {

/// Whether a parameter of a closed edge is in the turn before t0 or after t1.
bool EdgeEvaluator::over_end(double t) const {
    return is_closed(data_) && !in_range(t) && in_range(in_first_turn(data_, t));
}

/// The arc length between two parameters, like arc(), also for parameters in the turns beside the first one.
double EdgeEvaluator::arc_over_end(double from, double to) const {
    const auto from_start = [&](double t) {
        const double own = in_first_turn(data_, t);
        const double turns = std::round((t - own) / (t1_ - t0_));
        return arc(t0_, std::clamp(own, t0_, t1_)) + turns * arc(t0_, t1_);
    };
    return from_start(to) - from_start(from);
}

Answer EdgeEvaluator::middle_over_end(double from, double to) const {
    const double half = 0.5 * arc_over_end(from, to);
    double low = from;
    double high = to;
    // Halvings at most: the interval shrinks below double precision.
    constexpr int kHalvings = 52;
    for (int i = 0; i < kHalvings; ++i) {
        const double t = 0.5 * (low + high);
        (std::abs(arc_over_end(from, t)) < std::abs(half) ? low : high) = t;
    }
    return point(0.5 * (low + high));
}

/// The nearer of the nearest points before and after the end that lies in the range.
Answer EdgeEvaluator::nearest_over_end(const Vec3& point, double guess, double low, double high) const {
    const double turn = t1_ - t0_;
    Answer best;
    best.status = Status::BadQuery;
    for (const double shift : {-turn, 0.0, turn}) {
        const double a = std::max(low, t0_ + shift);
        const double b = std::min(high, t1_ + shift);
        if (a > b) {
            continue;
        }
        Answer answer = nearest(point, guess - shift, std::max(a - shift, t0_), std::min(b - shift, t1_));
        answer.t += shift;
        if (answer.found() && (!best.found() || answer.distance < best.distance)) {
            best = answer;
        }
    }
    return best;
}

}  // namespace mq::geometry

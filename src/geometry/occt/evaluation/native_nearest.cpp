// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Extrema_ExtPC.hxx>
#include <Extrema_ExtPS.hxx>
#include <Extrema_GenLocateExtPS.hxx>
#include <Extrema_POnCurv.hxx>
#include <Extrema_POnSurf.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/edge_evaluator.h"
#include "geometry/occt/evaluation/face_evaluator.h"

// The constructors of OpenCASCADE, for Evaluation::Native.
namespace mq::geometry {

namespace {

/// Tolerance of parameters of extrema.
constexpr double kParameter = 1e-10;
/// Relative accuracy of arc lengths.
constexpr double kLength = 1e-9;

}  // namespace

/// The nearest point by formula on an elementary surface; elsewhere the minimum that a local search from the guess
/// reaches. Nothing where OpenCASCADE finds none.
std::optional<FaceEvaluator::Projection> FaceEvaluator::native_nearest(const Vec3& p, const Vec2& guess) const {
    Projection best;
    best.square = std::numeric_limits<double>::infinity();
    const auto keep_nearer = [&](const Extrema_POnSurf& extremum, double square) {
        if (square < best.square) {
            extremum.Parameter(best.uv.x(), best.uv.y());
            best.square = square;
            best.found = true;
        }
    };
    if (elementary_) {
        const Extrema_ExtPS all(to_pnt(p), surface_, kParameter, kParameter, Extrema_ExtFlag_MIN);
        for (int i = 1; all.IsDone() && i <= all.NbExt(); ++i) {
            keep_nearer(all.Point(i), all.SquareDistance(i));
        }
    } else {
        const Vec2 start = into_domain(guess.x(), guess.y());
        Extrema_GenLocateExtPS near(surface_, kParameter, kParameter);
        near.Perform(to_pnt(p), start.x(), start.y());
        if (near.IsDone() && near.SquareDistance() <= (place(start.x(), start.y()) - p).squaredNorm()) {
            keep_nearer(near.Point(), near.SquareDistance());
        }
    }
    if (!best.found) {
        return std::nullopt;
    }
    best.at = first(best.uv.x(), best.uv.y());
    return is_local_minimum(p, best, search_) && !collapsed(best.at) ? std::optional(best) : std::nullopt;
}

double EdgeEvaluator::native_arc(double from, double to) const {
    const double scale = located_ ? std::abs(location_.ScaleFactor()) : 1.0;
    return (to < from ? -scale : scale) *
           GCPnts_AbscissaPoint::Length(*curve_, std::min(from, to), std::max(from, to), kLength * size_);
}

/// The parameter that halves the arc length.
double EdgeEvaluator::native_middle(double low, double high) const {
    const double half = 0.5 * GCPnts_AbscissaPoint::Length(*curve_, std::min(low, high), std::max(low, high));
    const double middle = 0.5 * (low + high);
    const GCPnts_AbscissaPoint found(*curve_, half, std::min(low, high), middle, kLength * half);
    return found.IsDone() ? found.Parameter() : middle;
}

/// The nearest of all extrema and the ends of the range; nothing where OpenCASCADE finds no extremum.
std::optional<double> EdgeEvaluator::native_nearest(const Vec3& point, double guess, double low, double high) const {
    const Extrema_ExtPC all(to_pnt(point), *curve_, low, high);
    if (!all.IsDone() || all.NbExt() == 0) {
        return std::nullopt;
    }
    double best = guess;
    double least = std::numeric_limits<double>::infinity();
    const auto keep_nearer = [&](double t, double square) {
        if (square < least) {
            least = square;
            best = t;
        }
    };
    for (int i = 1; i <= all.NbExt(); ++i) {
        keep_nearer(all.Point(i).Parameter(), all.SquareDistance(i));
    }
    for (const double end : {low, high}) {
        keep_nearer(end, (value(end) - point).squaredNorm());
    }
    return std::clamp(best, low, high);
}

}  // namespace mq::geometry

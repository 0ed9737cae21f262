// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/face_evaluator.h"

namespace mq::geometry {

namespace {

/// Pi: latitudes lie within half of it.
constexpr double kPi = 3.14159265358979323846;
/// Bounds of parameters that are unlimited.
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A Newton step below this fraction of the face's size is the last one: the next step would be of the order of its
/// square. Steps that are not full Newton steps converge slowly, and go on down to kLastSlowStep.
constexpr double kLastStep = 1e-7;
/// The last step if steps are no full Newton steps: near the rounding of distances.
constexpr double kLastSlowStep = 1e-11;

Vec2 clamped(const Vec2& uv, const ParameterBox& box) {
    return Vec2(std::clamp(uv.x(), box.low[0], box.high[0]), std::clamp(uv.y(), box.low[1], box.high[1]));
}

/// The surface by a Taylor series of second order, after a step so short that the remainder is below rounding.
SurfacePoint moved(const SurfacePoint& s, const Vec2& by) {
    SurfacePoint r;
    r.point =
        s.point + by.x() * (s.su + 0.5 * by.x() * s.suu + by.y() * s.suv) + by.y() * (s.sv + 0.5 * by.y() * s.svv);
    r.su = s.su + by.x() * s.suu + by.y() * s.suv;
    r.sv = s.sv + by.x() * s.suv + by.y() * s.svv;
    return r;
}

}  // namespace

/// A box of one period around the guess where the surface closes; elsewhere the surface's own bounds, or a box wider
/// than the face.
ParameterBox FaceEvaluator::elementary_box(const Vec2& guess) const {
    ParameterBox box;
    for (std::size_t i = 0; i < 2; ++i) {
        if (period_[i] > 0.0) {
            const double middle = guess[static_cast<Eigen::Index>(i)];
            box.low[i] = middle - 0.5 * period_[i];
            box.high[i] = middle + 0.5 * period_[i];
            continue;
        }
        const double margin = 0.5 * (trimmed_.high[i] - trimmed_.low[i]);
        box.low[i] = std::max(natural_.low[i], trimmed_.low[i] - margin);
        box.high[i] = std::min(natural_.high[i], trimmed_.high[i] + margin);
    }
    if (elementary_->kind == ElementarySurface::Kind::Sphere) {
        box.low[1] = -0.5 * kPi;
        box.high[1] = 0.5 * kPi;
    } else if (elementary_->kind == ElementarySurface::Kind::Cone) {
        // The box ends at the apex, unless the face itself extends beyond it.
        const double apex = -elementary_->radius / std::sin(elementary_->angle);
        if (apex <= trimmed_.low[1]) {
            box.low[1] = std::max(box.low[1], apex);
        } else if (apex >= trimmed_.high[1]) {
            box.high[1] = std::min(box.high[1], apex);
        }
    }
    return box;
}

void FaceEvaluator::set_search_box() {
    for (std::size_t i = 0; i < 2; ++i) {
        const double margin = 0.5 * (trimmed_.high[i] - trimmed_.low[i]);
        search_.low[i] = period_[i] > 0.0 ? -kInfinity : std::max(natural_.low[i], trimmed_.low[i] - margin);
        search_.high[i] = period_[i] > 0.0 ? kInfinity : std::min(natural_.high[i], trimmed_.high[i] + margin);
    }
}

/// One step towards the minimum of r^2 / 2, r = S(u, v) - p. A parameter that is at a bound and would leave it stays.
FaceEvaluator::Step FaceEvaluator::newton_step(const SurfacePoint& s, const Vec3& r, const Vec2& uv,
                                               const ParameterBox& box) const {
    const Vec2 gradient(r.dot(s.su), r.dot(s.sv));
    const Vec2 squares(s.su.squaredNorm(), s.sv.squaredNorm());
    const Vec2 hessian(squares.x() + r.dot(s.suu), squares.y() + r.dot(s.svv));
    std::array<bool, 2> free{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double tiny = kLastSlowStep * (i == 0 ? su_ * su_ : sv_ * sv_);
        free[i] = !(uv[k] <= box.low[i] && gradient[k] >= 0.0) && !(uv[k] >= box.high[i] && gradient[k] <= 0.0) &&
                  squares[k] > tiny;
    }
    Step step;
    step.squares = squares;
    if (free[0] && free[1]) {
        const double full = s.su.dot(s.sv) + r.dot(s.suv);
        const double det = hessian.x() * hessian.y() - full * full;
        step.minimum = hessian.x() > 0.0 && det > 1e-6 * squares.x() * squares.y();
        if (step.minimum) {
            step.move = Vec2(full * gradient.y() - hessian.y() * gradient.x(),
                             full * gradient.x() - hessian.x() * gradient.y()) /
                        det;
        } else {
            // The step to the projection on the tangent plane, where that is well-defined.
            const double mixed = s.su.dot(s.sv);
            const double gauss = std::max(squares.x() * squares.y() - mixed * mixed, 1e-6 * squares.x() * squares.y());
            step.move = Vec2(mixed * gradient.y() - squares.y() * gradient.x(),
                             mixed * gradient.x() - squares.x() * gradient.y()) /
                        gauss;
        }
        return step;
    }
    step.minimum = true;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        if (free[i]) {
            step.minimum = hessian[k] > 0.0;
            step.move[k] = -gradient[k] / (hessian[k] > 0.01 * squares[k] ? hessian[k] : squares[k]);
        }
    }
    return step;
}

/// @param p point in the surface's own coordinates.
FaceEvaluator::Projection FaceEvaluator::newton(const Vec3& p, const Vec2& start, const ParameterBox& box) const {
    // Newton steps at most; if a search needs more, it starts again from another place.
    constexpr int kNewtonSteps = 30;
    // Halvings of a step that does not reduce the distance.
    constexpr int kHalvings = 8;
    const Vec2 longest(0.25 * (trimmed_.high[0] - trimmed_.low[0]), 0.25 * (trimmed_.high[1] - trimmed_.low[1]));
    Projection projection;
    projection.uv = clamped(start, box);
    SurfacePoint s = second(projection.uv.x(), projection.uv.y());
    projection.square = (s.point - p).squaredNorm();
    for (int i = 0; i < kNewtonSteps; ++i) {
        const Step step = newton_step(s, s.point - p, projection.uv, box);
        Vec2 move = step.move.cwiseMin(longest).cwiseMax(-longest);
        const Vec2 next = clamped(projection.uv + move, box);
        move = next - projection.uv;
        const double square_moved = step.squares.x() * move.x() * move.x() + step.squares.y() * move.y() * move.y();
        const double last = (step.minimum ? kLastStep : kLastSlowStep) * size_;
        if (square_moved <= last * last) {
            projection.uv = next;
            projection.found = step.minimum;
            projection.at = moved(s, move);
            return projection;
        }
        int halvings = 0;
        for (; halvings <= kHalvings; ++halvings, move *= 0.5) {
            const Vec2 uv = projection.uv + move;
            s = second(uv.x(), uv.y());
            const double square = (s.point - p).squaredNorm();
            if (square <= projection.square * (1.0 + 1e-14) + 1e-28 * size_ * size_) {
                projection.uv = uv;
                projection.square = square;
                break;
            }
        }
        if (halvings > kHalvings) {
            return projection;
        }
    }
    return projection;
}

/// Whether one parameter has no effect, as at a pole, so that a search cannot leave in every direction.
bool FaceEvaluator::collapsed(const SurfacePoint& s) const {
    // A derivative shorter than this fraction of its usual length counts as zero.
    constexpr double kCollapsed = 1e-5;
    return s.su.norm() <= kCollapsed * su_ || s.sv.norm() <= kCollapsed * sv_;
}

/// Whether r is orthogonal to the surface, or points out of the box.
bool FaceEvaluator::is_local_minimum(const Vec3& p, const Projection& projection, const ParameterBox& box) const {
    const SurfacePoint& s = projection.at;
    const Vec3 r = s.point - p;
    const double slack = 1e-6 * r.norm() + 1e-9 * size_;
    const double across[2] = {r.dot(s.su), r.dot(s.sv)};
    const double squares[2] = {s.su.squaredNorm(), s.sv.squaredNorm()};
    for (std::size_t i = 0; i < 2; ++i) {
        const double x = projection.uv[static_cast<Eigen::Index>(i)];
        const bool sloping = across[i] * across[i] > slack * slack * squares[i];
        if (sloping && (across[i] > 0.0 ? x > box.low[i] : x < box.high[i])) {
            return false;
        }
    }
    return true;
}

/// Samples the face's box, for searches without a guess and for the face's bounding box: about as dense in both
/// directions, and several samples in each span of the surface.
void FaceEvaluator::sample() {
    // Samples of the face in all, unless the spans need more.
    constexpr double kTotal = 600.0;
    // Samples along each parameter at least.
    constexpr int kLeastSamples = 8;
    // Samples along each parameter at most; bounds time and memory.
    constexpr int kMostSamples = 160;
    const std::array<double, 2> range{trimmed_.high[0] - trimmed_.low[0], trimmed_.high[1] - trimmed_.low[1]};
    const std::array<double, 2> lengths{su_ * range[0], sv_ * range[1]};
    const std::array<int, 2> spans{surface_.NbUIntervals(GeomAbs_C2), surface_.NbVIntervals(GeomAbs_C2)};
    for (std::size_t i = 0; i < 2; ++i) {
        const double natural = natural_.high[i] - natural_.low[i];
        const double part = natural < Precision::Infinite() ? std::min(1.0, range[i] / natural) : 1.0;
        const double even = std::sqrt(kTotal * std::max(lengths[i], 1e-300) / std::max(lengths[1 - i], 1e-300));
        const double wanted = std::max(std::min(even, kTotal), std::ceil(3.0 * part * spans[i]));
        samples_[i] = static_cast<int>(std::clamp<double>(wanted, kLeastSamples, kMostSamples));
    }
    for (int i = 0; i <= samples_[0]; ++i) {
        for (int k = 0; k <= samples_[1]; ++k) {
            const Vec2 at = sample_at(i, k);
            grid_.push_back(place(at.x(), at.y()));
        }
    }
}

Vec2 FaceEvaluator::sample_at(int i, int k) const {
    return Vec2(trimmed_.low[0] + i * (trimmed_.high[0] - trimmed_.low[0]) / samples_[0],
                trimmed_.low[1] + k * (trimmed_.high[1] - trimmed_.low[1]) / samples_[1]);
}

/// The samples that are nearer than all their neighbours, best first, with their squared distances.
std::vector<std::pair<double, Vec2>> FaceEvaluator::best_samples(const Vec3& p) const {
    // Samples from which Newton's method starts at most.
    constexpr std::size_t kMostStarts = 6;
    const int nu = samples_[0] + 1;
    const int nv = samples_[1] + 1;
    std::vector<double> squares(grid_.size());
    std::transform(grid_.begin(), grid_.end(), squares.begin(), [&](const Vec3& q) { return (q - p).squaredNorm(); });
    std::vector<std::pair<double, Vec2>> found;
    for (int i = 0; i < nu; ++i) {
        for (int k = 0; k < nv; ++k) {
            const double here = squares[static_cast<std::size_t>(i * nv + k)];
            bool least = true;
            for (int a = std::max(0, i - 1); a <= std::min(nu - 1, i + 1) && least; ++a) {
                for (int b = std::max(0, k - 1); b <= std::min(nv - 1, k + 1) && least; ++b) {
                    least = here <= squares[static_cast<std::size_t>(a * nv + b)];
                }
            }
            if (least) {
                found.emplace_back(here, sample_at(i, k));
            }
        }
    }
    const std::size_t kept = std::min(kMostStarts, found.size());
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept), found.end(),
                      [](const auto& x, const auto& y) { return x.first < y.first; });
    found.resize(kept);
    return found;
}

/// At a pole a search has no direction: this takes the best of the points around it. Where a derivative vanishes
/// without a pole, it takes a point further in.
Vec2 FaceEvaluator::offset_from_pole(const Vec3& p, const Vec2& pole) const {
    // Points around the pole.
    constexpr int kTurns = 24;
    // Distance of these points from the pole, as a fraction of the samples' spacing.
    constexpr double kAside = 0.1;
    Vec2 inward;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double cell = (trimmed_.high[i] - trimmed_.low[i]) / samples_[i];
        inward[k] = pole[k] > 0.5 * (trimmed_.low[i] + trimmed_.high[i]) ? -kAside * cell : kAside * cell;
    }
    const int around = pole_parameter(pole);
    if (around < 0) {
        return pole + inward;
    }
    const auto a = static_cast<std::size_t>(around);
    Vec2 best = pole;
    double least = kInfinity;
    for (int i = 0; i <= kTurns; ++i) {
        Vec2 uv = pole + inward;
        uv[around] = trimmed_.low[a] + i * (trimmed_.high[a] - trimmed_.low[a]) / kTurns;
        const double square = (place(uv.x(), uv.y()) - p).squaredNorm();
        if (square < least) {
            least = square;
            best = uv;
        }
    }
    return best;
}

/// Newton's method from the best samples; where none comes closer (at a crease, at a pole), the best sample is improved
/// without derivatives.
FaceEvaluator::Projection FaceEvaluator::search(const Vec3& p, const ParameterBox& box) {
    if (grid_.empty()) {
        sample();
    }
    const std::vector<std::pair<double, Vec2>> starts = best_samples(p);
    Projection best;
    best.square = kInfinity;
    if (starts.empty()) {
        return best;
    }
    for (const auto& [square, uv] : starts) {
        const Projection projection = newton(p, collapsed(first(uv.x(), uv.y())) ? offset_from_pole(p, uv) : uv, box);
        if (projection.found && is_local_minimum(p, projection, box) && projection.square < best.square) {
            best = projection;
        }
    }
    if (!best.found || starts.front().first < best.square * (1.0 - 1e-9)) {
        best = pattern_search(p, clamped(starts.front().second, box), box);
    }
    return best;
}

FaceEvaluator::Projection FaceEvaluator::pattern_search(const Vec3& p, const Vec2& start,
                                                        const ParameterBox& box) const {
    Projection projection;
    projection.uv = start;
    projection.square = (place(start.x(), start.y()) - p).squaredNorm();
    Vec2 reach((trimmed_.high[0] - trimmed_.low[0]) / samples_[0], (trimmed_.high[1] - trimmed_.low[1]) / samples_[1]);
    // Steps of the search without derivatives at most.
    constexpr int kPatternSteps = 400;
    // Relative step at which that search ends: near double precision.
    constexpr double kEnd = 1e-12;
    double part = 1.0;
    for (int i = 0; i < kPatternSteps && part > kEnd; ++i) {
        bool better = false;
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            const Vec2 uv = clamped(projection.uv + part * reach.cwiseProduct(way), box);
            const double square = (place(uv.x(), uv.y()) - p).squaredNorm();
            if (square < projection.square) {
                projection.uv = uv;
                projection.square = square;
                better = true;
            }
        }
        part *= better ? 1.0 : 0.5;
    }
    projection.found = std::isfinite(projection.square);
    projection.at = first(projection.uv.x(), projection.uv.y());
    return projection;
}

/// The answer at the projection (u, v) of `point`, on the turn nearest to the guess.
Answer FaceEvaluator::answer_at(const Vec3& point, const Projection& projection, const Vec2& guess) const {
    const double u = branch_nearest(projection.uv.x(), guess.x(), period_[0]);
    const double v = branch_nearest(projection.uv.y(), guess.y(), period_[1]);
    Answer answer = at(u, v, projection.at);
    answer.distance = (answer.point - point).norm();
    return answer;
}

Answer FaceEvaluator::nearest(const Vec3& point, double u, double v) {
    Answer answer;
    answer.status = Status::BadQuery;
    if (!(std::abs(u) < 1e50) || !(std::abs(v) < 1e50)) {
        return answer;
    }
    const Vec3 p = local(point);
    const Vec2 guess(u, v);
    answer.status = Status::NotFound;
    if (native_) {
        if (const auto projection = native_nearest(p, guess)) {
            return answer_at(point, *projection, guess);
        }
    } else if (elementary_) {
        const auto projection = elementary_->nearest(p, elementary_box(guess), guess);
        return projection ? answer_at(point, {projection->uv, 0.0, true, projection->at}, guess) : answer;
    }
    Projection projection = newton(p, guess, search_);
    const bool local = projection.found && is_local_minimum(p, projection, search_);
    if (!local || collapsed(projection.at)) {
        const Projection other = search(p, search_);
        projection = local && projection.square <= other.square ? projection : other;
    }
    return projection.found ? answer_at(point, projection, guess) : answer;
}

Answer FaceEvaluator::on_line(const Vec3& point, const Vec3& along, double u, double v) const {
    // Newton steps at most; from a guess as good as a triangle's parameters few are needed.
    constexpr int kLineSteps = 16;
    // A distance from the line below this fraction of the face's size counts as zero.
    constexpr double kOnLine = 1e-13;
    // The least sine of the angle between line and surface, below which the step has no length.
    constexpr double kAlong = 1e-9;
    Answer answer;
    answer.status = Status::NotFound;
    if (!(std::abs(u) < 1e50) || !(std::abs(v) < 1e50)) {
        answer.status = Status::BadQuery;
        return answer;
    }
    const Vec3 p = local(point);
    Vec3 direction = along;
    if (located_) {
        direction = to_vec(gp_Vec(along.x(), along.y(), along.z()).Transformed(inverse_)).normalized();
    }
    const Vec3 across = direction.unitOrthogonal(), other = direction.cross(across);
    const Vec2 longest(0.25 * (trimmed_.high[0] - trimmed_.low[0]), 0.25 * (trimmed_.high[1] - trimmed_.low[1]));
    Vec2 uv = clamped(Vec2(u, v), search_);
    double before = kInfinity;
    for (int i = 0; i < kLineSteps; ++i) {
        const SurfacePoint s = first(uv.x(), uv.y());
        const Vec3 r = s.point - p;
        const Vec2 off(r.dot(across), r.dot(other));
        const double size = off.norm();
        // Steps that are rounding alone do not come nearer any more.
        if (size <= kOnLine * size_ || (size <= 1e3 * kOnLine * size_ && size >= before)) {
            answer = at(uv.x(), uv.y(), s);
            answer.t = (answer.point - point).dot(along);
            answer.distance = std::abs(answer.t);
            return answer;
        }
        before = size;
        const double a = s.su.dot(across), b = s.sv.dot(across), c = s.su.dot(other), d = s.sv.dot(other);
        const double det = a * d - b * c;
        if (!(std::abs(det) > kAlong * s.su.norm() * s.sv.norm())) {
            return answer;
        }
        const Vec2 move = Vec2(b * off.y() - d * off.x(), c * off.x() - a * off.y()) / det;
        uv = clamped(uv + move.cwiseMin(longest).cwiseMax(-longest), search_);
    }
    return answer;
}

Answer FaceEvaluator::nearest_global(const Vec3& point) {
    Answer answer;
    answer.status = Status::NotFound;
    const Vec3 p = local(point);
    const Vec2 middle(0.5 * (trimmed_.low[0] + trimmed_.high[0]), 0.5 * (trimmed_.low[1] + trimmed_.high[1]));
    if (elementary_ && !native_) {
        const auto projection = elementary_->nearest(p, trimmed_, middle);
        return projection ? answer_at(point, {projection->uv, 0.0, true, projection->at}, projection->uv) : answer;
    }
    const Projection projection = search(p, trimmed_);
    return projection.found ? answer_at(point, projection, projection.uv) : answer;
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/face_evaluator.h"

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {

namespace {

/// Su x Sv below this fraction of its usual size, or of |Su| |Sv|, has no reliable direction.
constexpr double kSingular = 1e-8;
/// Distance of (u, v) from the surface's bounds, as a fraction of its range, that is accepted: curves overshoot by
/// rounding.
constexpr double kOvershoot = 1e-3;

ElementarySurface with_frame(ElementarySurface::Kind kind, const gp_Ax3& frame) {
    ElementarySurface s;
    s.kind = kind;
    s.origin = to_vec(frame.Location());
    s.x = to_vec(frame.XDirection());
    s.y = to_vec(frame.YDirection());
    s.z = to_vec(frame.Direction());
    return s;
}

}  // namespace

FaceEvaluator::FaceEvaluator(const TopoDS_Face& shape, const Face& data, Evaluation evaluation)
    : shape_(shape),
      native_(evaluation == Evaluation::Native),
      sign_(data.reversed ? -1.0 : 1.0),
      tolerance_(data.tolerance),
      period_(data.period) {
    TopLoc_Location location;
    surface_.Load(BRep_Tool::Surface(shape, location));
    location_ = location.Transformation();
    inverse_ = location_.Inverted();
    located_ = !location.IsIdentity();
    mirrored_ = located_ && mirrors(location_);
    set_bounds(data);
    set_search_box();
    if (!native_ && surface_.GetType() == GeomAbs_BSplineSurface) {
        patches_.emplace(surface_.BSpline());
        patched_ = patches_->inside();
        for (std::size_t i = 0; i < 2; ++i) {  // on the bounds the adaptor evaluates the side on which the face lies
            patched_.low[i] = std::max(patched_.low[i], natural_.low[i]);
            patched_.high[i] = std::min(patched_.high[i], natural_.high[i]);
        }
    }
    set_references();
    set_elementary();
}

void FaceEvaluator::set_bounds(const Face& data) {
    // Bounds of parameters beyond this count as infinite.
    constexpr double kFar = 1e6;
    natural_.low = {surface_.FirstUParameter(), surface_.FirstVParameter()};
    natural_.high = {surface_.LastUParameter(), surface_.LastVParameter()};
    for (std::size_t i = 0; i < 2; ++i) {
        trimmed_.low[i] = std::abs(data.low[i]) < Precision::Infinite() ? data.low[i] : -kFar;
        trimmed_.high[i] = std::abs(data.high[i]) < Precision::Infinite() ? data.high[i] : kFar;
    }
}

void FaceEvaluator::set_references() {
    Box box;
    for (int i = 0; i <= 4; ++i) {
        for (int k = 0; k <= 4; ++k) {
            const SurfacePoint s = first(trimmed_.low[0] + 0.25 * i * (trimmed_.high[0] - trimmed_.low[0]),
                                         trimmed_.low[1] + 0.25 * k * (trimmed_.high[1] - trimmed_.low[1]));
            su_ = std::max(su_, s.su.norm());
            sv_ = std::max(sv_, s.sv.norm());
            box.add(s.point);
        }
    }
    size_ = (box.high - box.low).norm();
}

void FaceEvaluator::set_elementary() {
    using Kind = ElementarySurface::Kind;
    switch (surface_.GetType()) {
        case GeomAbs_Plane:
            elementary_ = with_frame(Kind::Plane, surface_.Plane().Position());
            break;
        case GeomAbs_Cylinder:
            elementary_ = with_frame(Kind::Cylinder, surface_.Cylinder().Position());
            elementary_->radius = surface_.Cylinder().Radius();
            break;
        case GeomAbs_Cone:
            elementary_ = with_frame(Kind::Cone, surface_.Cone().Position());
            elementary_->radius = surface_.Cone().RefRadius();
            elementary_->angle = surface_.Cone().SemiAngle();
            break;
        case GeomAbs_Sphere:
            elementary_ = with_frame(Kind::Sphere, surface_.Sphere().Position());
            elementary_->radius = surface_.Sphere().Radius();
            break;
        case GeomAbs_Torus:
            // On a torus that meets itself the nearest angle about the axis is not always that of the point.
            if (surface_.Torus().MinorRadius() < surface_.Torus().MajorRadius()) {
                elementary_ = with_frame(Kind::Torus, surface_.Torus().Position());
                elementary_->radius = surface_.Torus().MajorRadius();
                elementary_->minor = surface_.Torus().MinorRadius();
            }
            break;
        default:
            break;
    }
}

std::optional<ElementarySurface> FaceEvaluator::elementary() const {
    if (!elementary_ || !located_) {
        return elementary_;
    }
    ElementarySurface s = *elementary_;
    s.origin = to_vec(to_pnt(s.origin).Transformed(location_));
    double scale = 1.0;
    for (Vec3* axis : {&s.x, &s.y, &s.z}) {
        *axis = to_vec(gp_Vec(axis->x(), axis->y(), axis->z()).Transformed(location_));
        scale = axis->norm();
        *axis /= scale;
    }
    s.radius *= scale;
    s.minor *= scale;
    return s;
}

bool FaceEvaluator::legal(double u, double v) const {
    const double uv[2] = {u, v};
    for (std::size_t i = 0; i < 2; ++i) {
        if (!(std::abs(uv[i]) < Precision::Infinite())) {
            return false;
        }
        const double slack = kOvershoot * (natural_.high[i] - natural_.low[i]);
        if (period_[i] == 0.0 && (uv[i] < natural_.low[i] - slack || uv[i] > natural_.high[i] + slack)) {
            return false;
        }
    }
    return true;
}

/// Moves (u, v) into the surface's own range: B-splines are not defined outside, and OpenCASCADE reaches a far period
/// turn by turn.
Vec2 FaceEvaluator::into_domain(double u, double v) const {
    Vec2 uv(u, v);
    for (Eigen::Index i = 0; i < 2; ++i) {
        const double low = natural_.low[static_cast<std::size_t>(i)];
        const double high = natural_.high[static_cast<std::size_t>(i)];
        const double period = period_[static_cast<std::size_t>(i)];
        if (period > 0.0 && (uv[i] < low || uv[i] > high)) {
            uv[i] -= period * std::floor((uv[i] - low) / period);
        }
        uv[i] = std::clamp(uv[i], low, high);
    }
    return uv;
}

bool FaceEvaluator::in_a_patch(double u, double v) const {
    return u > patched_.low[0] && u < patched_.high[0] && v > patched_.low[1] && v < patched_.high[1];
}

Vec3 FaceEvaluator::place(double u, double v) const {
    if (in_a_patch(u, v)) {
        return patches_->point(u, v);
    }
    const Vec2 uv = into_domain(u, v);
    return in_a_patch(uv.x(), uv.y()) ? patches_->point(uv.x(), uv.y()) : first(u, v).point;
}

SurfacePoint FaceEvaluator::first(double u, double v) const {
    if (in_a_patch(u, v)) {
        return patches_->first(u, v);
    }
    const Vec2 uv = into_domain(u, v);
    if (in_a_patch(uv.x(), uv.y())) {
        return patches_->first(uv.x(), uv.y());
    }
    gp_Pnt p;
    gp_Vec su;
    gp_Vec sv;
    surface_.D1(uv.x(), uv.y(), p, su, sv);
    SurfacePoint s;
    s.point = to_vec(p);
    s.su = to_vec(su);
    s.sv = to_vec(sv);
    return s;
}

SurfacePoint FaceEvaluator::second(double u, double v) const {
    if (in_a_patch(u, v)) {
        return patches_->second(u, v);
    }
    const Vec2 uv = into_domain(u, v);
    if (in_a_patch(uv.x(), uv.y())) {
        return patches_->second(uv.x(), uv.y());
    }
    gp_Pnt p;
    gp_Vec d[5];
    surface_.D2(uv.x(), uv.y(), p, d[0], d[1], d[2], d[3], d[4]);
    SurfacePoint s;
    s.point = to_vec(p);
    s.su = to_vec(d[0]);
    s.sv = to_vec(d[1]);
    s.suu = to_vec(d[2]);
    s.svv = to_vec(d[3]);
    s.suv = to_vec(d[4]);
    return s;
}

SurfacePoint FaceEvaluator::placed(SurfacePoint s) const {
    if (!located_) {
        return s;
    }
    s.point = to_vec(to_pnt(s.point).Transformed(location_));
    for (Vec3* d : {&s.su, &s.sv, &s.suu, &s.suv, &s.svv}) {
        *d = to_vec(gp_Vec(d->x(), d->y(), d->z()).Transformed(location_));
    }
    return s;
}

Vec3 FaceEvaluator::local(const Vec3& point) const {
    return located_ ? to_vec(to_pnt(point).Transformed(inverse_)) : point;
}

/// The unit vector along Su x Sv at a point in the surface's own coordinates.
std::optional<Vec3> FaceEvaluator::regular_normal(const SurfacePoint& s) const {
    const Vec3 n = s.su.cross(s.sv);
    const double size = n.norm();
    const double squares = s.su.squaredNorm() * s.sv.squaredNorm();
    if (!(size > kSingular * su_ * sv_) || !(size * size > kSingular * kSingular * squares)) {
        return std::nullopt;
    }
    return Vec3(n / size);
}

/// The normal extrapolated from two points beside (u, v).
std::optional<Vec3> FaceEvaluator::normal_beside(const Vec2& uv, const Vec2& aside) const {
    const auto far = regular_normal(first(uv.x() + aside.x(), uv.y() + aside.y()));
    const auto near = regular_normal(first(uv.x() + 0.5 * aside.x(), uv.y() + 0.5 * aside.y()));
    if (!far || !near) {
        return std::nullopt;
    }
    return Vec3((2.0 * *near - *far).normalized());
}

/// The parameter along which the surface is constant at a pole: 0 for u, 1 for v, -1 where (u, v) is no pole. A
/// vanishing derivative alone makes no pole: the points along it may still differ.
int FaceEvaluator::pole_parameter(const Vec2& uv) const {
    // Largest extent of a pole's points, as a fraction of the face's size.
    constexpr double kPoint = 1e-6;
    const Vec3 here = first(uv.x(), uv.y()).point;
    for (int i = 0; i < 2; ++i) {
        const auto k = static_cast<std::size_t>(i);
        double reach = 0.0;
        for (const double part : {0.0, 0.3, 0.6, 1.0}) {
            Vec2 other = uv;
            other[i] = trimmed_.low[k] + part * (trimmed_.high[k] - trimmed_.low[k]);
            reach = std::max(reach, (first(other.x(), other.y()).point - here).norm());
        }
        if (reach <= kPoint * size_) {
            return i;
        }
    }
    return -1;
}

/// The limit of the normals of all points around a singular one, if they agree: at the pole of a sphere, not at an
/// apex.
std::optional<Vec3> FaceEvaluator::limit_normal(double u, double v) const {
    // Distance of the points beside a singular one, as a fraction of the face's range.
    constexpr double kAside = 1e-3;
    // Least cosine between normals that agree.
    constexpr double kAgreement = 0.98;
    const Vec2 here(u, v);
    const Vec2 size(trimmed_.high[0] - trimmed_.low[0], trimmed_.high[1] - trimmed_.low[1]);
    const Vec2 middle(0.5 * (trimmed_.low[0] + trimmed_.high[0]), 0.5 * (trimmed_.low[1] + trimmed_.high[1]));
    Vec2 inward = kAside * size;
    for (Eigen::Index i = 0; i < 2; ++i) {
        inward[i] *= here[i] > middle[i] ? -1.0 : 1.0;
    }
    const int pole = pole_parameter(here);
    std::vector<std::optional<Vec3>> around;
    if (pole >= 0) {
        Vec2 aside = inward;
        aside[pole] = 0.0;
        for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            Vec2 turned = here;
            turned[pole] = trimmed_.low[static_cast<std::size_t>(pole)] + part * size[pole];
            around.push_back(normal_beside(turned, aside));
        }
        around.push_back(normal_beside(here, aside));
    } else {
        around.push_back(normal_beside(here, Vec2(inward.x(), 0.0)));
        around.push_back(normal_beside(here, Vec2(0.0, inward.y())));
        around.push_back(normal_beside(here, inward));
    }
    const std::optional<Vec3> limit = around.back();
    for (const auto& n : around) {
        if (limit && n && n->dot(*limit) < kAgreement) {
            return std::nullopt;
        }
    }
    return limit;
}

void FaceEvaluator::set_normal(double u, double v, const SurfacePoint& s, Answer& answer) const {
    std::optional<Vec3> n = regular_normal(s);
    if (!n) {
        n = limit_normal(u, v);
    }
    answer.status = n ? Status::Ok : Status::Singular;
    if (!n) {
        return;
    }
    if (!located_) {
        answer.normal = sign_ * *n;
        return;
    }
    // A vector product changes its sign in a mirror: M a x M b = det(M) / scale * M (a x b).
    const double mirror = mirrored_ ? -1.0 : 1.0;
    const gp_Vec turned = gp_Vec(n->x(), n->y(), n->z()).Transformed(location_);
    answer.normal = sign_ * mirror * to_vec(turned).normalized();
}

Answer FaceEvaluator::at(double u, double v) const {
    return at(u, v, first(u, v));
}

/// @param s the result of `first` at (u, v).
Answer FaceEvaluator::at(double u, double v, const SurfacePoint& s) const {
    Answer answer;
    answer.u = u;
    answer.v = v;
    set_normal(u, v, s, answer);
    answer.point = located_ ? to_vec(to_pnt(s.point).Transformed(location_)) : s.point;
    return answer;
}

Answer FaceEvaluator::point(double u, double v) const {
    if (!legal(u, v)) {
        Answer answer;
        answer.status = Status::BadQuery;
        return answer;
    }
    return at(u, v);
}

Answer FaceEvaluator::point_of_curve(double u, double v) const {
    Vec2 uv(u, v);
    for (Eigen::Index i = 0; i < 2; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (period_[k] == 0.0) {
            uv[i] = std::clamp(uv[i], natural_.low[k], natural_.high[k]);
        }
    }
    return at(uv.x(), uv.y());
}

Answer FaceEvaluator::derivatives(double u, double v) const {
    Answer answer = point(u, v);
    if (answer.found()) {
        const SurfacePoint s = placed(second(u, v));
        answer.derivatives = {s.su, s.sv, s.suu, s.suv, s.svv};
    }
    return answer;
}

/// Principal curvatures are positive where the surface bends towards its outward normal: negative all over a ball.
Answer FaceEvaluator::curvatures(double u, double v) const {
    Answer answer = point(u, v);
    if (answer.status != Status::Ok) {
        return answer;
    }
    SurfacePoint s = second(u, v);
    std::optional<Vec3> n = regular_normal(s);
    if (!n) {
        // At the pole of a sphere the fundamental forms vanish, but not beside it.
        constexpr double kAside = 1e-3;
        s = second(u + kAside * (0.5 * (trimmed_.low[0] + trimmed_.high[0]) - u),
                   v + kAside * (0.5 * (trimmed_.low[1] + trimmed_.high[1]) - v));
        n = regular_normal(s);
    }
    if (!n) {
        answer.status = Status::Singular;
        answer.normal = Vec3::Zero();
        return answer;
    }
    const double mirror = mirrored_ ? -1.0 : 1.0;
    const double scale = located_ ? std::abs(location_.ScaleFactor()) : 1.0;
    const double e = s.su.squaredNorm();
    const double f = s.su.dot(s.sv);
    const double g = s.sv.squaredNorm();
    const double l = s.suu.dot(*n);
    const double m = s.suv.dot(*n);
    const double k = s.svv.dot(*n);
    const double det = e * g - f * f;
    const double mean = 0.5 * (e * k - 2.0 * f * m + g * l) / det;
    const double root = std::sqrt(std::max(0.0, mean * mean - (l * k - m * m) / det));
    const double larger = mean < 0.0 ? mean - root : mean + root;
    const double smaller = mean < 0.0 ? mean + root : mean - root;
    answer.u = sign_ * mirror * larger / scale;
    answer.v = sign_ * mirror * smaller / scale;
    return answer;
}

Answer FaceEvaluator::contains(double u, double v, double border) {
    Answer answer;
    answer.u = u;
    answer.v = v;
    if (!legal(u, v)) {
        answer.status = Status::BadQuery;
        return answer;
    }
    const double width = border > 0.0 ? std::min(border, tolerance_) : tolerance_;
    const double tolerance = std::min(surface_.UResolution(width), surface_.VResolution(width));
    BRepTopAdaptor_FClass2d& classifier = classifiers_.try_emplace(width, shape_, tolerance).first->second;
    // All turns of (u, v) within the face's bounds; the classifier's own walk through the periods does not end for a
    // far u.
    answer.status = Status::Ok;
    answer.side = -1;
    std::array<std::vector<double>, 2> turns;
    for (std::size_t i = 0; i < 2; ++i) {
        const double x = i == 0 ? u : v;
        if (period_[i] == 0.0) {
            turns[i].push_back(x);
            continue;
        }
        const double from = x - period_[i] * std::floor((x - trimmed_.low[i] + tolerance) / period_[i]);
        for (double turn = from; turn <= trimmed_.high[i] + tolerance; turn += period_[i]) {
            turns[i].push_back(turn);
        }
    }
    for (const double a : turns[0]) {
        for (const double b : turns[1]) {
            const TopAbs_State state = classifier.Perform(gp_Pnt2d(a, b), Standard_False);
            answer.side = std::max(answer.side, state == TopAbs_IN ? 1 : (state == TopAbs_ON ? 0 : -1));
        }
    }
    return answer;
}

}  // namespace mq::geometry

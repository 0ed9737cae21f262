// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/analytic/analytic_model.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/closed_edge.h"
#include "geometry/elementary/curve.h"
#include "geometry/elementary/surface.h"

namespace mq::geometry {

namespace {

using Surface = ElementarySurface;

constexpr double kPi = 3.14159265358979323846;  // radians in half a turn
constexpr double kTwoPi = 2.0 * kPi;            // radians in a turn
constexpr double kTiny = 1e-9;                  // largest value that counts as 0 where dimensions are about 1

Answer with_status(Status status) {
    Answer answer;
    answer.status = status;
    return answer;
}

class AnalyticModel final : public Model {
  public:
    /// The depth of a point in the solid: positive inside; the distance to its border, or a bound of it.
    std::function<double(const Vec3&)> depth;

    int add_node(const Vec3& point);
    int add_line(int from, int to);
    int add_curve(const Curve3& curve, int from, int to, double t0, double t1);
    int add_pole(int node);
    /// A disk has its bounds from -radius to radius.
    int add_face(const Surface& surface, bool reversed, const ParameterBox& bounds, double disk_radius = 0.0);
    void add_use(int face, int edge, bool forward, const Curve2& curve);
    /// Adds a use whose curve is that of a straight edge on a plane.
    void add_straight_use(int face, int edge, bool forward);
    void finish(const Vec3& low, const Vec3& high);

    Answer answer(const Query& query) noexcept override;
    std::optional<Surface> elementary_surface(int i) override { return surfaces_[static_cast<std::size_t>(i)]; }
    void add_definition(Entity entity, int frame, Fingerprint& key) override;
    void add_definition_of_use(int use, Fingerprint& key) override;

  private:
    Answer on_edge(const Query& query) const;
    Answer edge_point(int edge, double t) const;
    Answer edge_at_distance(const Query& query) const;
    Answer edge_nearest(const Query& query) const;
    Answer use_on_face(const Query& query) const;
    Answer on_face(const Query& query) const;
    Answer face_point(int face, double u, double v) const;
    Answer face_derivatives(const Query& query) const;
    Answer face_curvatures(const Query& query) const;
    Answer face_nearest(const Query& query, bool global) const;
    Answer face_contains(const Query& query) const;
    Answer volume_contains(const Query& query) const;

    std::vector<Curve3> curves_;
    std::vector<Curve2> use_curves_;
    std::vector<Surface> surfaces_;
    std::vector<double> disks_;
};

template <class Vector>
void add_curve_to(Fingerprint& key, const Curve<Vector>& curve) {
    add_to(key, curve.round ? 1 : 0);
    for (const Vector* v : {&curve.origin, &curve.x, &curve.y}) {
        for (const double number : *v) {
            add_to(key, number);
        }
    }
    add_to(key, curve.radius);
}

void AnalyticModel::add_definition(Entity entity, int /*frame*/, Fingerprint& key) {
    const auto i = static_cast<std::size_t>(entity.index);
    if (entity.dimension == 0) {
        add_to(key, topology_.nodes[i].point);
    } else if (entity.dimension == 1) {
        add_curve_to(key, curves_[i]);
    } else {
        const Surface& s = surfaces_[i];
        add_to(key, static_cast<int>(s.kind));
        for (const Vec3* v : {&s.origin, &s.x, &s.y, &s.z}) {
            add_to(key, *v);
        }
        for (const double number : {s.radius, s.minor, s.angle, disks_[i]}) {
            add_to(key, number);
        }
    }
}

void AnalyticModel::add_definition_of_use(int use, Fingerprint& key) {
    add_curve_to(key, use_curves_[static_cast<std::size_t>(use)]);
}

int AnalyticModel::add_node(const Vec3& point) {
    constexpr double kTolerance = 1e-7;  // tolerance of nodes and edges, mm: OpenCASCADE's default
    topology_.nodes.push_back(Node{point, kTolerance});
    return static_cast<int>(topology_.nodes.size()) - 1;
}

int AnalyticModel::add_curve(const Curve3& curve, int from, int to, double t0, double t1) {
    Edge edge;
    edge.nodes = {from, to};
    edge.t0 = t0;
    edge.t1 = t1;
    edge.tolerance = topology_.nodes[static_cast<std::size_t>(from)].tolerance;
    topology_.edges.push_back(edge);
    curves_.push_back(curve);
    return static_cast<int>(curves_.size()) - 1;
}

int AnalyticModel::add_line(int from, int to) {
    const Vec3& a = topology_.nodes[static_cast<std::size_t>(from)].point;
    const Vec3& b = topology_.nodes[static_cast<std::size_t>(to)].point;
    Curve3 curve;
    curve.origin = a;
    curve.x = (b - a).normalized();
    return add_curve(curve, from, to, 0.0, (b - a).norm());
}

int AnalyticModel::add_pole(int node) {
    Curve3 point;
    point.origin = topology_.nodes[static_cast<std::size_t>(node)].point;
    const int edge = add_curve(point, node, node, 0.0, kTwoPi);
    topology_.edges.back().degenerate = true;
    return edge;
}

int AnalyticModel::add_face(const Surface& surface, bool reversed, const ParameterBox& bounds, double disk_radius) {
    // Names of the surfaces in the order of Surface::Kind.
    static constexpr const char* kNames[] = {"plane", "cylinder", "cone", "sphere", "torus"};
    Face face;
    face.reversed = reversed;
    face.tolerance = 1e-7;
    face.low = bounds.low;
    face.high = bounds.high;
    face.period = {surface.kind == Surface::Kind::Plane ? 0.0 : kTwoPi,
                   surface.kind == Surface::Kind::Torus ? kTwoPi : 0.0};
    face.surface = kNames[static_cast<int>(surface.kind)];
    face.loops.emplace_back();
    topology_.faces.push_back(face);
    surfaces_.push_back(surface);
    disks_.push_back(disk_radius);
    return static_cast<int>(surfaces_.size()) - 1;
}

void AnalyticModel::add_use(int face, int edge, bool forward, const Curve2& curve) {
    const int id = static_cast<int>(topology_.uses.size());
    topology_.uses.push_back(EdgeUse{edge, face, forward, false});
    topology_.edges[static_cast<std::size_t>(edge)].uses.push_back(id);
    topology_.faces[static_cast<std::size_t>(face)].loops.front().uses.push_back(id);
    use_curves_.push_back(curve);
}

void AnalyticModel::add_straight_use(int face, int edge, bool forward) {
    const Surface& plane = surfaces_[static_cast<std::size_t>(face)];
    const Curve3& line = curves_[static_cast<std::size_t>(edge)];
    const Vec3 d = line.origin - plane.origin;
    add_use(face, edge, forward,
            line2(Vec2(d.dot(plane.x), d.dot(plane.y)), Vec2(line.x.dot(plane.x), line.x.dot(plane.y))));
}

void AnalyticModel::finish(const Vec3& low, const Vec3& high) {
    topology_.box.add(low);
    topology_.box.add(high);
    Volume volume;
    for (std::size_t i = 0; i < topology_.faces.size(); ++i) {
        volume.sides.push_back(Volume::Side{static_cast<int>(i), false});
    }
    topology_.volumes.push_back(volume);
}

Answer AnalyticModel::answer(const Query& query) noexcept {
    using Kind = Query::Kind;
    const bool finite = std::isfinite(query.u) && std::isfinite(query.v) && std::isfinite(query.t) &&
                        std::isfinite(query.t2) && std::isfinite(query.distance) && query.point.allFinite();
    if (!finite || query.index < 0) {
        return with_status(Status::BadQuery);
    }
    switch (query.kind) {
        case Kind::EdgePoint:
        case Kind::EdgeMiddle:
        case Kind::EdgeAtDistance:
        case Kind::EdgeNearest:
        case Kind::EdgeLength:
            return on_edge(query);
        case Kind::UseOnFace:
            return use_on_face(query);
        case Kind::VolumeContains:
            return volume_contains(query);
        default:
            return on_face(query);
    }
}

Answer AnalyticModel::on_edge(const Query& query) const {
    if (query.index >= static_cast<int>(curves_.size())) {
        return with_status(Status::BadQuery);
    }
    const Edge& edge = topology_.edges[static_cast<std::size_t>(query.index)];
    const bool nearest = query.kind == Query::Kind::EdgeNearest;
    const double first = nearest ? query.u : query.t;
    const double last = nearest ? query.v : (query.kind == Query::Kind::EdgePoint ? query.t : query.t2);
    if (edge.degenerate || !has_parameter(edge, first, kTiny) || !has_parameter(edge, last, kTiny) ||
        (nearest && first > last)) {
        return with_status(Status::BadQuery);
    }
    switch (query.kind) {
        case Query::Kind::EdgePoint:
            return edge_point(query.index, query.t);
        case Query::Kind::EdgeMiddle:
            return edge_point(query.index, 0.5 * (query.t + query.t2));
        case Query::Kind::EdgeAtDistance:
            return edge_at_distance(query);
        case Query::Kind::EdgeNearest:
            return edge_nearest(query);
        default: {
            Answer answer = with_status(Status::Ok);
            answer.distance =
                curves_[static_cast<std::size_t>(query.index)].derivative(0.0).norm() * std::abs(query.t2 - query.t);
            return answer;
        }
    }
}

Answer AnalyticModel::edge_point(int edge, double t) const {
    const Curve3& curve = curves_[static_cast<std::size_t>(edge)];
    Answer answer = with_status(Status::Ok);
    answer.t = t;
    answer.point = curve.at(t);
    answer.normal = curve.derivative(t);
    return answer;
}

Answer AnalyticModel::edge_at_distance(const Query& query) const {
    const Curve3& curve = curves_[static_cast<std::size_t>(query.index)];
    if (query.distance < 0.0) {
        return with_status(Status::BadQuery);
    }
    double step = query.distance;
    if (curve.round) {
        if (query.distance > 2.0 * curve.radius) {
            return with_status(Status::NotFound);
        }
        step = 2.0 * std::asin(0.5 * query.distance / curve.radius);
    }
    if (step > std::abs(query.t2 - query.t) + kTiny) {
        return with_status(Status::NotFound);
    }
    return edge_point(query.index, query.t2 < query.t ? query.t - step : query.t + step);
}

Answer AnalyticModel::edge_nearest(const Query& query) const {
    const Curve3& curve = curves_[static_cast<std::size_t>(query.index)];
    const Vec3 d = query.point - curve.origin;
    double t = std::clamp(query.t, query.u, query.v);
    if (!curve.round) {
        t = std::clamp(d.dot(curve.x), query.u, query.v);
    } else if (std::hypot(d.dot(curve.x), d.dot(curve.y)) > kTiny * curve.radius) {
        t = branch_nearest(std::atan2(d.dot(curve.y), d.dot(curve.x)), t, kTwoPi);
        if (t < query.u || t > query.v) {
            t = std::clamp(branch_nearest(t, 0.5 * (query.u + query.v), kTwoPi), query.u, query.v);
        }
    }
    Answer answer = edge_point(query.index, t);
    answer.distance = (answer.point - query.point).norm();
    return answer;
}

Answer AnalyticModel::use_on_face(const Query& query) const {
    if (query.index >= static_cast<int>(use_curves_.size())) {
        return with_status(Status::BadQuery);
    }
    const auto i = static_cast<std::size_t>(query.index);
    const EdgeUse& use = topology_.uses[i];
    const Edge& edge = topology_.edges[static_cast<std::size_t>(use.edge)];
    if (!has_parameter(edge, query.t, kTiny)) {
        return with_status(Status::BadQuery);
    }
    const Vec2 uv = use_curves_[i].at(in_first_turn(edge, query.t));
    Answer answer = face_point(use.face, uv.x(), uv.y());
    answer.t = query.t;
    return answer;
}

Answer AnalyticModel::on_face(const Query& query) const {
    if (query.index >= static_cast<int>(surfaces_.size()) || query.kind == Query::Kind::FaceOnLine) {
        return with_status(Status::BadQuery);  // all surfaces here have closed forms
    }
    const bool projects = query.kind == Query::Kind::FaceNearest || query.kind == Query::Kind::FaceNearestGlobal;
    if (!projects && surfaces_[static_cast<std::size_t>(query.index)].kind == Surface::Kind::Sphere &&
        std::abs(query.v) > 0.5 * kPi + kTiny) {
        return with_status(Status::BadQuery);
    }
    switch (query.kind) {
        case Query::Kind::FacePoint:
            return face_point(query.index, query.u, query.v);
        case Query::Kind::FaceDerivatives:
            return face_derivatives(query);
        case Query::Kind::FaceCurvatures:
            return face_curvatures(query);
        case Query::Kind::FaceContains:
            return face_contains(query);
        default:
            return face_nearest(query, query.kind == Query::Kind::FaceNearestGlobal);
    }
}

Answer AnalyticModel::face_point(int face, double u, double v) const {
    const auto i = static_cast<std::size_t>(face);
    const Surface& surface = surfaces_[i];
    const SurfacePoint s = surface.at(u, v);
    Answer answer = with_status(Status::Ok);
    answer.u = u;
    answer.v = v;
    answer.point = s.point;
    Vec3 normal = s.su.cross(s.sv);
    if (surface.kind == Surface::Kind::Sphere) {
        // The normal by formula, at the poles too, where Su vanishes.
        normal = s.point - surface.origin;
    } else if (surface.kind == Surface::Kind::Cone && s.su.norm() <= kTiny * surface.radius) {
        answer.status = Status::Singular;
        return answer;
    }
    answer.normal = (topology_.faces[i].reversed ? -1.0 : 1.0) * normal.normalized();
    return answer;
}

Answer AnalyticModel::face_derivatives(const Query& query) const {
    Answer answer = face_point(query.index, query.u, query.v);
    const SurfacePoint s = surfaces_[static_cast<std::size_t>(query.index)].at(query.u, query.v);
    answer.derivatives = {s.su, s.sv, s.suu, s.suv, s.svv};
    return answer;
}

/// All curved faces of these solids have Su x Sv outward.
Answer AnalyticModel::face_curvatures(const Query& query) const {
    Answer answer = face_point(query.index, query.u, query.v);
    answer.u = 0.0;
    answer.v = 0.0;
    if (answer.status != Status::Ok) {
        return answer;
    }
    const Surface& s = surfaces_[static_cast<std::size_t>(query.index)];
    switch (s.kind) {
        case Surface::Kind::Plane:
            break;
        case Surface::Kind::Cylinder:
            answer.u = -1.0 / s.radius;
            break;
        case Surface::Kind::Cone:
            answer.u = -std::cos(s.angle) / (s.radius + query.v * std::sin(s.angle));
            break;
        case Surface::Kind::Sphere:
            answer.u = -1.0 / s.radius;
            answer.v = answer.u;
            break;
        case Surface::Kind::Torus:
            answer.u = -1.0 / s.minor;
            answer.v = -std::cos(query.v) / (s.radius + s.minor * std::cos(query.v));
            if (std::abs(answer.v) > std::abs(answer.u)) {
                std::swap(answer.u, answer.v);
            }
            break;
    }
    return answer;
}

Answer AnalyticModel::face_nearest(const Query& query, bool global) const {
    const auto i = static_cast<std::size_t>(query.index);
    const Face& face = topology_.faces[i];
    ParameterBox box{face.low, face.high};
    Vec2 guess(0.5 * (face.low[0] + face.high[0]), 0.5 * (face.low[1] + face.high[1]));
    if (!global) {
        guess = Vec2(query.u, query.v);
        for (std::size_t k = 0; k < 2; ++k) {
            const double margin = 0.5 * (face.period[k] > 0.0 ? face.period[k] : face.high[k] - face.low[k]);
            const double near = guess[static_cast<Eigen::Index>(k)];
            box.low[k] = (face.period[k] > 0.0 ? near : face.low[k]) - margin;
            box.high[k] = (face.period[k] > 0.0 ? near : face.high[k]) + margin;
        }
        if (surfaces_[i].kind == Surface::Kind::Sphere) {
            box.low[1] = face.low[1];
            box.high[1] = face.high[1];
        } else if (surfaces_[i].kind == Surface::Kind::Cone) {
            box.high[1] = face.high[1];
        }
    }
    const auto projection = surfaces_[i].nearest(query.point, box, guess);
    if (!projection) {
        return with_status(Status::NotFound);
    }
    Answer answer = face_point(query.index, projection->uv.x(), projection->uv.y());
    answer.distance = (answer.point - query.point).norm();
    return answer;
}

Answer AnalyticModel::face_contains(const Query& query) const {
    const auto i = static_cast<std::size_t>(query.index);
    const Face& face = topology_.faces[i];
    double inside = 0.0;
    if (disks_[i] > 0.0) {
        inside = disks_[i] - std::hypot(query.u, query.v);
    } else {
        inside = face.high[0] - face.low[0];
        const double uv[2] = {query.u, query.v};
        for (std::size_t k = 0; k < 2; ++k) {
            const double x = branch_nearest(uv[k], 0.5 * (face.low[k] + face.high[k]), face.period[k]);
            inside = std::min(inside, std::min(x - face.low[k], face.high[k] - x));
        }
    }
    Answer answer = with_status(Status::Ok);
    answer.u = query.u;
    answer.v = query.v;
    answer.side = inside > 1e-7 ? 1 : (inside < -1e-7 ? -1 : 0);
    return answer;
}

Answer AnalyticModel::volume_contains(const Query& query) const {
    if (query.index != 0) {
        return with_status(Status::BadQuery);
    }
    const double inside = depth(query.point);
    Answer answer = with_status(Status::Ok);
    answer.point = query.point;
    answer.side = inside > 1e-7 ? 1 : (inside < -1e-7 ? -1 : 0);
    return answer;
}

void require_positive(double value, const char* what) {
    if (!(value > 0.0) || !std::isfinite(value)) {
        throw InvalidInput(phrases::kNotPositive, {{"name", what}, {"number", in_digits(value, 6)}});
    }
}

Surface plane_at(double z) {
    Surface plane;
    plane.origin = Vec3(0.0, 0.0, z);
    return plane;
}

/// The side of a cylinder or cone: edges 0 (top), 1 (seam), 2 (bottom), v from 0 to `length`.
void add_side(AnalyticModel& model, const Surface& surface, double length) {
    const int side = model.add_face(surface, false, {{0.0, 0.0}, {kTwoPi, length}});
    model.add_use(side, 0, false, line2(Vec2(0.0, length), Vec2(1.0, 0.0)));
    model.add_use(side, 1, false, line2(Vec2(0.0, 0.0), Vec2(0.0, 1.0)));
    model.add_use(side, 2, true, line2(Vec2(0.0, 0.0), Vec2(1.0, 0.0)));
    model.add_use(side, 1, true, line2(Vec2(kTwoPi, 0.0), Vec2(0.0, 1.0)));
}

void add_disk(AnalyticModel& model, double z, double radius, int edge, bool reversed) {
    const int disk = model.add_face(plane_at(z), reversed, {{-radius, -radius}, {radius, radius}}, radius);
    model.add_use(disk, edge, true, circle2(radius));
}

}  // namespace

std::shared_ptr<Model> make_sphere(double radius) {
    require_positive(radius, "The radius of a sphere");
    auto model = std::make_shared<AnalyticModel>();
    const int top = model->add_node(Vec3(0.0, 0.0, radius));
    const int bottom = model->add_node(Vec3(0.0, 0.0, -radius));
    model->add_pole(top);
    model->add_curve(circle3(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), radius), bottom, top, 1.5 * kPi, 2.5 * kPi);
    model->add_pole(bottom);
    Surface sphere;
    sphere.kind = Surface::Kind::Sphere;
    sphere.radius = radius;
    const int face = model->add_face(sphere, false, {{0.0, -0.5 * kPi}, {kTwoPi, 0.5 * kPi}});
    model->add_use(face, 0, false, line2(Vec2(0.0, 0.5 * kPi), Vec2(1.0, 0.0)));
    model->add_use(face, 1, false, line2(Vec2(0.0, -kTwoPi), Vec2(0.0, 1.0)));
    model->add_use(face, 2, true, line2(Vec2(0.0, -0.5 * kPi), Vec2(1.0, 0.0)));
    model->add_use(face, 1, true, line2(Vec2(kTwoPi, -kTwoPi), Vec2(0.0, 1.0)));
    model->depth = [radius](const Vec3& p) { return radius - p.norm(); };
    model->finish(Vec3::Constant(-radius), Vec3::Constant(radius));
    return model;
}

std::shared_ptr<Model> make_cylinder(double radius, double height) {
    require_positive(radius, "The radius of a cylinder");
    require_positive(height, "The height of a cylinder");
    auto model = std::make_shared<AnalyticModel>();
    const Vec3 up(0.0, 0.0, height);
    const int top = model->add_node(Vec3(radius, 0.0, height));
    const int bottom = model->add_node(Vec3(radius, 0.0, 0.0));
    model->add_curve(circle3(up, Vec3::UnitX(), Vec3::UnitY(), radius), top, top, 0.0, kTwoPi);
    model->add_line(bottom, top);
    model->add_curve(circle3(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), radius), bottom, bottom, 0.0, kTwoPi);
    Surface cylinder;
    cylinder.kind = Surface::Kind::Cylinder;
    cylinder.radius = radius;
    add_side(*model, cylinder, height);
    add_disk(*model, height, radius, 0, false);
    add_disk(*model, 0.0, radius, 2, true);
    model->depth = [radius, height](const Vec3& p) {
        return std::min(radius - std::hypot(p.x(), p.y()), std::min(p.z(), height - p.z()));
    };
    model->finish(Vec3(-radius, -radius, 0.0), Vec3(radius, radius, height));
    return model;
}

std::shared_ptr<Model> make_cone(double radius, double height) {
    require_positive(radius, "The radius of a cone");
    require_positive(height, "The height of a cone");
    auto model = std::make_shared<AnalyticModel>();
    const double length = std::hypot(radius, height);
    const int apex = model->add_node(Vec3(0.0, 0.0, height));
    const int bottom = model->add_node(Vec3(radius, 0.0, 0.0));
    model->add_pole(apex);
    model->add_line(bottom, apex);
    model->add_curve(circle3(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), radius), bottom, bottom, 0.0, kTwoPi);
    Surface cone;
    cone.kind = Surface::Kind::Cone;
    cone.radius = radius;
    cone.angle = -std::atan2(radius, height);
    add_side(*model, cone, length);
    add_disk(*model, 0.0, radius, 2, true);
    model->depth = [radius, height, length](const Vec3& p) {
        const double across = (radius - std::hypot(p.x(), p.y())) * height - radius * p.z();
        return std::min(across / length, p.z());
    };
    model->finish(Vec3(-radius, -radius, 0.0), Vec3(radius, radius, height));
    return model;
}

std::shared_ptr<Model> make_torus(double major, double minor) {
    require_positive(minor, "The minor radius of a torus");
    require_positive(major - minor, "The major radius of a torus, less the minor one,");
    auto model = std::make_shared<AnalyticModel>();
    const int node = model->add_node(Vec3(major + minor, 0.0, 0.0));
    model->add_curve(circle3(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), major + minor), node, node, 0.0, kTwoPi);
    model->add_curve(circle3(Vec3(major, 0.0, 0.0), Vec3::UnitX(), Vec3::UnitZ(), minor), node, node, 0.0, kTwoPi);
    Surface torus;
    torus.kind = Surface::Kind::Torus;
    torus.radius = major;
    torus.minor = minor;
    const int face = model->add_face(torus, false, {{0.0, 0.0}, {kTwoPi, kTwoPi}});
    model->add_use(face, 0, false, line2(Vec2(0.0, kTwoPi), Vec2(1.0, 0.0)));
    model->add_use(face, 1, false, line2(Vec2(0.0, 0.0), Vec2(0.0, 1.0)));
    model->add_use(face, 0, true, line2(Vec2(0.0, 0.0), Vec2(1.0, 0.0)));
    model->add_use(face, 1, true, line2(Vec2(kTwoPi, 0.0), Vec2(0.0, 1.0)));
    model->depth = [major, minor](const Vec3& p) {
        return minor - std::hypot(std::hypot(p.x(), p.y()) - major, p.z());
    };
    model->finish(Vec3(-major - minor, -major - minor, -minor), Vec3(major + minor, major + minor, minor));
    return model;
}

std::shared_ptr<Model> make_box(double a, double b, double c) {
    require_positive(a, "The length of a box");
    require_positive(b, "The width of a box");
    require_positive(c, "The height of a box");
    auto model = std::make_shared<AnalyticModel>();
    for (const double x : {0.0, a}) {
        for (const double y : {0.0, b}) {
            model->add_node(Vec3(x, y, c));
            model->add_node(Vec3(x, y, 0.0));
        }
    }
    // Ends of the box's edges.
    static constexpr int kEdges[12][2] = {{1, 0}, {0, 2}, {3, 2}, {1, 3}, {5, 4}, {4, 6},
                                          {7, 6}, {5, 7}, {1, 5}, {0, 4}, {3, 7}, {2, 6}};
    for (const auto& edge : kEdges) {
        model->add_line(edge[0], edge[1]);
    }
    // The edges of the box's faces. Every face runs backward, forward, forward, backward along its four edges.
    static constexpr int kFaces[6][4] = {{0, 3, 2, 1},   {4, 7, 6, 5},  {8, 0, 9, 4},
                                         {10, 2, 11, 6}, {3, 8, 7, 10}, {1, 9, 5, 11}};
    const Vec3 x_directions[3] = {Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitX()};
    const Vec3 y_directions[3] = {-Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitY()};
    const ParameterBox bounds[3] = {{{0.0, -b}, {c, 0.0}}, {{0.0, 0.0}, {c, a}}, {{0.0, 0.0}, {a, b}}};
    for (int i = 0; i < 6; ++i) {
        Surface plane;
        plane.x = x_directions[i / 2];
        plane.y = y_directions[i / 2];
        plane.z = plane.x.cross(plane.y);
        plane.origin = i % 2 == 1 ? Vec3(Vec3(a, b, c)[i / 2] * plane.z) : Vec3(Vec3::Zero());
        const int face = model->add_face(plane, i % 2 == 0, bounds[i / 2]);
        for (int k = 0; k < 4; ++k) {
            model->add_straight_use(face, kFaces[i][k], k == 1 || k == 2);
        }
    }
    model->depth = [a, b, c](const Vec3& p) {
        return std::min(p.minCoeff(), std::min(a - p.x(), std::min(b - p.y(), c - p.z())));
    };
    model->finish(Vec3::Zero(), Vec3(a, b, c));
    return model;
}

}  // namespace mq::geometry

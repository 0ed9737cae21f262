// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/slider.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "triangulate/corner_angle.h"
#include "triangulate/deviation.h"
#include "triangulate/disc_change.h"
#include "triangulate/segments_at.h"

namespace mq::triangulate {

namespace {

using geometry::Query;
using mesh::SurfaceMesh;

// Of the way to the next vertex, either way; then around the best of these.
constexpr std::array<double, 8> kSteps{-0.6, -0.45, -0.3, -0.15, 0.15, 0.3, 0.45, 0.6};
constexpr std::array<double, 4> kFineSteps{-0.1, -0.05, 0.05, 0.1};
constexpr std::size_t kMaxTried = 3;
constexpr double kNear = 0.94;  // of the tolerance: between the places that are measured the mesh may be farther
constexpr std::array<double, 3> kOnCurve{0.35, 0.5, 0.65};

double smallest_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::min({angle_between(b - a, c - a), angle_between(c - b, a - b), angle_between(a - c, b - c)});
}

}  // namespace

Slider::Slider(Workspace& work, const Sizing& sizing)
    : work_(work), sizing_(sizing), segments_at_(segments_at_vertices(work.mesh)) {}

// None for a vertex that ends a triangle in a narrow corner of the part: the other edge of the corner ends it, too.
std::optional<Slider::Bead> Slider::bead_at(int vertex) const {
    const SurfaceMesh& mesh = work_.mesh;
    if (mesh.vertex(vertex).entity[0] != 1 || vertex >= static_cast<int>(segments_at_.size())) {
        return std::nullopt;
    }
    Bead bead;
    bead.near = segments_at_[static_cast<std::size_t>(vertex)][0];
    bead.far = segments_at_[static_cast<std::size_t>(vertex)][1];
    if (bead.near < 0 || bead.far < 0 || bead.near == bead.far) {
        return std::nullopt;
    }
    bead.angle = M_PI;
    for (const SurfaceMesh::SegmentUse& use : mesh.segment(bead.near).uses) {
        const bool leaves = mesh.vertex_of(use.half_edge) == vertex;
        bead.spokes.push_back(mesh.star(leaves ? use.half_edge : SurfaceMesh::next(use.half_edge)));
        for (const int h : bead.spokes.back()) {
            const int t = SurfaceMesh::triangle_of(h);
            if (narrow_corner_of(mesh, t) >= 0) {
                return std::nullopt;
            }
            bead.angle = std::min(bead.angle, smallest_angle(mesh, t).angle);
        }
    }
    return bead;
}

std::vector<int> Slider::triangles_around(const Bead& bead) {
    std::vector<int> triangles;
    for (const std::vector<int>& around : bead.spokes) {
        for (const int h : around) {
            triangles.push_back(SurfaceMesh::triangle_of(h));
        }
    }
    return triangles;
}

// Of the triangles as they are now.
std::uint64_t Slider::key(const Bead& bead) const {
    std::uint64_t sum = 0;
    for (const int t : triangles_around(bead)) {
        sum = KeyHash()(sum ^ ordered_key(static_cast<std::uint32_t>(t), work_.mesh.stamp(t))) + sum;
    }
    return sum;
}

double Slider::angle_with(const Bead& bead, const Vec3& point) const {
    const SurfaceMesh& mesh = work_.mesh;
    double least = M_PI;
    for (const std::vector<int>& around : bead.spokes) {
        for (const int h : around) {
            least = std::min(
                least, smallest_of(point, mesh.point_of(SurfaceMesh::next(h)), mesh.point_of(SurfaceMesh::prev(h))));
        }
    }
    return least;
}

// Those with angles of at least so much, the best first.
std::vector<Slider::Place> Slider::places_for(const Bead& bead, const std::vector<double>& parameters,
                                              double at_least) const {
    geometry::Engine::Batch batch;
    for (const double t : parameters) {
        batch.push_back(Query::edge_point(work_.mesh.segment(bead.near).edge, t));
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(batch));
    std::vector<Place> places;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (answers[i].found()) {
            const Vec3 point = work_.grid.snap(answers[i].point);
            places.push_back({parameters[i], point, angle_with(bead, point)});
        }
    }
    places.erase(std::remove_if(places.begin(), places.end(), [&](const Place& p) { return p.angle < at_least; }),
                 places.end());
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.angle > b.angle; });
    return places;
}

std::vector<Slider::Place> Slider::places_for(const Bead& bead, double at_least) const {
    const double t = work_.mesh.segment(bead.near).t[1];
    const double back = t - work_.mesh.segment(bead.near).t[0];
    const double on = work_.mesh.segment(bead.far).t[1] - t;
    const auto at = [&](double step) { return t + step * (step < 0.0 ? back : on); };
    std::vector<double> parameters;
    for (const double step : kSteps) {
        parameters.push_back(at(step));
    }
    const std::vector<Place> coarse = places_for(bead, parameters, 0.0);
    if (coarse.empty()) {
        return {};
    }
    const double best = (coarse.front().t - t) / ((coarse.front().t - t) * on > 0.0 ? on : back);
    parameters = {coarse.front().t};
    for (const double step : kFineSteps) {
        parameters.push_back(at(best + step));
    }
    return places_for(bead, parameters, at_least);
}

bool Slider::lengths_allowed(const Bead& bead, const Vec3& point) const {
    const SurfaceMesh& mesh = work_.mesh;
    const auto allowed = [&](int h, int other) {
        const double length = (mesh.point_of(other) - point).norm();
        return length >= work_.shortest_allowed() && (!sizing_.bounds.any() || length <= sizing_.bounds.of(mesh, h));
    };
    return std::all_of(bead.spokes.begin(), bead.spokes.end(), [&](const std::vector<int>& around) {
        const int last = SurfaceMesh::prev(around.back());
        return allowed(last, last) &&
               std::all_of(around.begin(), around.end(), [&](int h) { return allowed(h, SurfaceMesh::next(h)); });
    });
}

// The two segments; or no farther than these are now.
bool Slider::curve_near(const Bead& bead, const Place& place) const {
    const SurfaceMesh::Segment& near = work_.mesh.segment(bead.near);
    const SurfaceMesh::Segment& far = work_.mesh.segment(bead.far);
    const auto farthest = [&](double t, const Vec3& middle) {
        geometry::Engine::Batch batch;
        const auto add = [&](const Vec3& a, double ta, const Vec3& b, double tb) {
            for (const double at : kOnCurve) {
                batch.push_back(Query::edge_nearest(near.edge, work_.grid.to_part((1.0 - at) * a + at * b),
                                                    (1.0 - at) * ta + at * tb, std::min(ta, tb), std::max(ta, tb)));
            }
        };
        add(work_.mesh.vertex(near.vertices[0]).point, near.t[0], middle, t);
        add(middle, t, work_.mesh.vertex(far.vertices[1]).point, far.t[1]);
        double distance = 0.0;
        for (const geometry::Answer& answer : work_.session.ask(std::move(batch))) {
            distance = answer.found() ? std::max(distance, answer.distance) : 1e300;
        }
        return distance;
    };
    const double distance = farthest(place.t, place.point);
    return distance <= kNear * sizing_.tolerance ||
           distance <= farthest(near.t[1], work_.mesh.vertex(near.vertices[1]).point);
}

// Spokes and triangles, aligned with their surfaces and near to them; or no worse than they are now.
bool Slider::surfaces_near(const Bead& bead, const std::vector<SurfaceMesh::Site>& sites) const {
    const SurfaceMesh& mesh = work_.mesh;
    double least = kAligned;
    double aligned = 1.0;
    geometry::Engine::Batch batch;
    std::vector<char> now;
    const auto add = [&](int h, const SurfaceMesh::Site& top, bool old) {
        const SurfaceMesh::Site& b = mesh.site(mesh.site_of(SurfaceMesh::next(h)));
        const SurfaceMesh::Site& c = mesh.site(mesh.site_of(SurfaceMesh::prev(h)));
        const auto ask = [&](const Vec3& p, const Vec2& uv) {
            batch.push_back(Query::face_nearest(mesh.face_of(h / 3), work_.grid.to_part(p), uv.x(), uv.y()));
            now.push_back(old ? 1 : 0);
        };
        if (mesh.twin(h) >= 0) {
            const double at = edge_peak(top, b).at;
            ask((1.0 - at) * top.point + at * b.point, (1.0 - at) * top.uv + at * b.uv);
            ask(0.5 * (top.point + b.point), 0.5 * (top.uv + b.uv));
        }
        const auto w = expected_peak(top, b, c).weights;
        ask(w[0] * top.point + w[1] * b.point + w[2] * c.point, w[0] * top.uv + w[1] * b.uv + w[2] * c.uv);
    };
    for (std::size_t k = 0; k < bead.spokes.size(); ++k) {
        for (const int h : bead.spokes[k]) {
            least = std::min(least, alignment(mesh, SurfaceMesh::triangle_of(h)));
            aligned = std::min(aligned, alignment({sites[k].point, sites[k].normal},
                                                  corner_of(mesh, mesh.site_of(SurfaceMesh::next(h))),
                                                  corner_of(mesh, mesh.site_of(SurfaceMesh::prev(h)))));
            add(h, sites[k], false);
            add(h, mesh.site(mesh.site_of(h)), true);
        }
    }
    if (aligned < least || !(sizing_.tolerance > 0.0)) {
        return aligned >= least;
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(batch));
    std::array<double, 2> farthest{0.0, kNear * sizing_.tolerance};
    for (std::size_t i = 0; i < answers.size(); ++i) {
        double& distance = farthest[static_cast<std::size_t>(now[i])];
        distance = std::max(distance, answers[i].found() ? answers[i].distance : now[i] != 0 ? 0.0 : 1e300);
    }
    return farthest[0] <= farthest[1];
}

bool Slider::put(const Bead& bead, const Place& place, double bound) {
    if (!lengths_allowed(bead, place.point) || (sizing_.tolerance > 0.0 && !curve_near(bead, place))) {
        return false;
    }
    SurfaceMesh& mesh = work_.mesh;
    geometry::Engine::Batch batch;
    for (const SurfaceMesh::SegmentUse& use : mesh.segment(bead.near).uses) {
        batch.push_back(Query::use_on_face(use.use, place.t));
    }
    std::vector<SurfaceMesh::Site> sites;
    for (const geometry::Answer& answer : work_.session.ask(std::move(batch))) {
        if (!answer.found()) {
            return false;
        }
        sites.push_back({-1, Vec2(answer.u, answer.v), answer.normal, place.point});
    }
    if (!surfaces_near(bead, sites)) {
        return false;
    }
    const int vertex = mesh.add_vertex(place.point, {1, mesh.segment(bead.near).edge});
    std::vector<int> indices;
    for (SurfaceMesh::Site& site : sites) {
        site.vertex = vertex;
        indices.push_back(mesh.add_site(site));
    }
    const std::vector<int> around = triangles_around(bead);
    const std::optional<Exemption> reason = take_exemptions(work_, around);
    work_.maxmin.put_between(bead.near, bead.far, vertex, place.t, bead.spokes, indices);
    segments_at_.resize(static_cast<std::size_t>(mesh.vertex_count()), {-1, -1});
    segments_at_[static_cast<std::size_t>(vertex)] = {bead.near, bead.far};
    exempt_bad(work_, around, bound, reason);
    return true;
}

std::vector<int> Slider::improve(int triangle, double bound, const std::function<double(double)>& enough) {
    if (sizing_.turn > 0.0 || sizing_.growth > 0.0) {
        return {};  // longer edges would have to be weighed against all around
    }
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const auto bead = bead_at(work_.mesh.vertex_of(h));
        if (!bead || !tried_.insert(key(*bead)).second) {
            continue;
        }
        std::vector<Place> places = places_for(*bead, enough(bead->angle));
        places.resize(std::min(places.size(), kMaxTried));
        if (std::any_of(places.begin(), places.end(), [&](const Place& place) { return put(*bead, place, bound); })) {
            return triangles_around(*bead);
        }
    }
    return {};
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/optimise/edge_vertex_relocation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/angle.h"
#include "triangulate/measure/backward_distance.h"
#include "triangulate/measure/distance_probes.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/optimise/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/incident_segments.h"

namespace mq::triangulate {

namespace {

using geometry::Query;

constexpr double kFar = 1e300;  // mm: distance of a point without projection, larger than any tolerance

// Returns the half-edge at an input angle of the shape below the bound, or -1.
int forced_corner_of(const ClassifiedMesh& mesh, int triangle, double bound) {
    const int corner = narrow_corner_of(mesh, triangle);
    return corner >= 0 && angle_at(mesh, corner) < bound ? corner : -1;
}

// Returns the smallest angle of the triangle with `point` as origin of `h`, except the angle at the half-edge
// `corner`, radians.
double smallest_beside(const ClassifiedMesh& mesh, int h, const Vec3& point, int corner) {
    const std::array<int, 3> at{h, ClassifiedMesh::next(h), ClassifiedMesh::prev(h)};
    const std::array<Vec3, 3> p{point, mesh.point_of(at[1]), mesh.point_of(at[2])};
    double least = M_PI;
    for (std::size_t i = 0; i < 3; ++i) {
        if (at[i] != corner) {
            least = std::min(least, angle_between(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]));
        }
    }
    return least;
}

}  // namespace

EdgeVertexRelocation::EdgeVertexRelocation(Workspace& work, const Sizing& sizing)
    : work_(work), sizing_(sizing), segments_at_(segments_at_vertices(work.mesh)) {}

std::optional<EdgeVertexRelocation::EdgeVertexStar> EdgeVertexRelocation::bead_at(int vertex, double bound) const {
    const ClassifiedMesh& mesh = work_.mesh;
    if (mesh.vertex(vertex).entity[0] != 1 || vertex >= static_cast<int>(segments_at_.size())) {
        return std::nullopt;
    }
    EdgeVertexStar bead;
    bead.near = segments_at_[static_cast<std::size_t>(vertex)][0];
    bead.far = segments_at_[static_cast<std::size_t>(vertex)][1];
    if (bead.near < 0 || bead.far < 0 || bead.near == bead.far || mesh.segment(bead.near).vertices[1] != vertex ||
        mesh.segment(bead.far).vertices[0] != vertex) {
        return std::nullopt;  // the order may differ beside segments that are split on trial
    }
    for (const ClassifiedMesh::SegmentUse& use : mesh.segment(bead.near).uses) {
        bead.spokes.push_back(mesh.star(mesh.leaving(use, vertex)));
        std::vector<int>& corners = bead.corners.emplace_back();
        for (const int h : bead.spokes.back()) {
            corners.push_back(forced_corner_of(mesh, ClassifiedMesh::triangle_of(h), bound));
        }
    }
    return bead;
}

std::vector<int> EdgeVertexRelocation::triangles_around(const EdgeVertexStar& bead) {
    std::vector<int> triangles;
    for (const std::vector<int>& around : bead.spokes) {
        for (const int h : around) {
            triangles.push_back(ClassifiedMesh::triangle_of(h));
        }
    }
    return triangles;
}

// No value where an angle is below `at_least`: most places are found to be worse by their first triangles.
std::optional<EdgeVertexRelocation::Angles> EdgeVertexRelocation::angles_with(const EdgeVertexStar& bead,
                                                                              const Vec3& point,
                                                                              const Angles& at_least) const {
    constexpr double kNoSquaredSine = 2.0;
    const ClassifiedMesh& mesh = work_.mesh;
    const double enough = sine_squared_below(at_least.beside);
    double squared_sine = kNoSquaredSine;
    Angles least;
    for (std::size_t k = 0; k < bead.spokes.size(); ++k) {
        for (std::size_t i = 0; i < bead.spokes[k].size(); ++i) {
            const int h = bead.spokes[k][i];
            const int corner = bead.corners[k][i];
            if (corner < 0) {
                squared_sine =
                    std::min(squared_sine, squared_sine_of_smallest_angle(point, mesh.point_of(ClassifiedMesh::next(h)),
                                                                          mesh.point_of(ClassifiedMesh::prev(h))));
            } else {
                least.in_corners = std::min(least.in_corners, smallest_beside(mesh, h, point, corner));
            }
            if (squared_sine < enough || least.in_corners < at_least.in_corners) {
                return std::nullopt;
            }
        }
    }
    least.beside = squared_sine < kNoSquaredSine ? std::asin(std::sqrt(squared_sine)) : least.beside;
    return least.beside >= at_least.beside ? std::optional(least) : std::nullopt;
}

// Returns the points of the vertex's curve at these parameters; no value where it has none.
std::vector<std::optional<Vec3>> EdgeVertexRelocation::points_at(const EdgeVertexStar& bead,
                                                                 const std::vector<double>& parameters) const {
    geometry::Engine::Batch batch;
    for (const double t : parameters) {
        batch.push_back(Query::edge_point(work_.mesh.segment(bead.near).edge, t));
    }
    std::vector<std::optional<Vec3>> points;
    for (const geometry::Answer& answer : work_.session.ask(std::move(batch))) {
        points.push_back(answer.found() ? std::optional<Vec3>(work_.grid.snap(answer.point)) : std::nullopt);
    }
    return points;
}

// Returns the place with the largest angles among those that reach `at_least`, the first of equal ones.
std::optional<EdgeVertexRelocation::Place> EdgeVertexRelocation::best_place(const EdgeVertexStar& bead,
                                                                            const std::vector<double>& parameters,
                                                                            Angles at_least) const {
    const std::vector<std::optional<Vec3>> points = points_at(bead, parameters);
    std::optional<Place> best;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto angles = points[i] ? angles_with(bead, *points[i], at_least) : std::nullopt;
        if (angles && (!best || angles->beside > best->angle)) {
            best = Place{parameters[i], *points[i], angles->beside};
            at_least.beside = angles->beside;
        }
    }
    return best;
}

// Returns the places near the best one whose angles reach `at_least`, the best first.
std::vector<EdgeVertexRelocation::Place> EdgeVertexRelocation::places_for(const EdgeVertexStar& bead,
                                                                          const Angles& at_least) const {
    const double t = work_.mesh.segment(bead.near).t[1];
    const double back = t - work_.mesh.segment(bead.near).t[0];
    const double on = work_.mesh.segment(bead.far).t[1] - t;
    const auto at = [&](double step) { return t + step * (step < 0.0 ? back : on); };
    std::vector<double> parameters;
    const double shorter = std::abs(back) < std::abs(on) ? back : on;
    for (const double step : OptimisationTuning::kEdgeSteps) {
        parameters.push_back(at(step));
        // Innermost pieces at small input angles are far longer than the next ones.
        parameters.push_back(t + step * shorter);
    }
    const auto coarse = best_place(bead, parameters, {0.0, at_least.in_corners});
    if (!coarse) {
        return {};
    }
    const double best = (coarse->t - t) / ((coarse->t - t) * on > 0.0 ? on : back);
    parameters = {coarse->t};
    for (const double step : OptimisationTuning::kFineSteps) {
        parameters.push_back(at(best + step));
    }
    const std::vector<std::optional<Vec3>> points = points_at(bead, parameters);
    std::vector<Place> places;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (const auto angles = points[i] ? angles_with(bead, *points[i], at_least) : std::nullopt) {
            places.push_back({parameters[i], *points[i], angles->beside});
        }
    }
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.angle > b.angle; });
    return places;
}

bool EdgeVertexRelocation::lengths_allowed(const EdgeVertexStar& bead, const Vec3& point) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const auto allowed = [&](int h, int other) {
        const double length = (mesh.point_of(other) - point).norm();
        return length >= work_.shortest_allowed() && (!sizing_.bounds.any() || length <= sizing_.bounds.of(mesh, h));
    };
    return std::all_of(bead.spokes.begin(), bead.spokes.end(), [&](const std::vector<int>& around) {
        const int last = ClassifiedMesh::prev(around.back());
        return allowed(last, last) &&
               std::all_of(around.begin(), around.end(), [&](int h) { return allowed(h, ClassifiedMesh::next(h)); });
    });
}

// Returns the largest distance of the two segments from the curve with the vertex at that place, mm.
double EdgeVertexRelocation::distance_from_curve(const EdgeVertexStar& bead, const PointOfEdge& middle) const {
    const ClassifiedMesh::Segment& near = work_.mesh.segment(bead.near);
    const ClassifiedMesh::Segment& far = work_.mesh.segment(bead.far);
    geometry::Engine::Batch batch;
    const PointOfEdge first{work_.mesh.vertex(near.vertices[0]).point, near.t[0]};
    const PointOfEdge last{work_.mesh.vertex(far.vertices[1]).point, far.t[1]};
    add_segment_probes(work_, near.edge, first, middle, batch);
    add_segment_probes(work_, near.edge, middle, last, batch);
    return std::max({largest_distance(work_.session.ask(std::move(batch)), kFar),
                     backward_distance(work_, near.edge, first, middle).distance,
                     backward_distance(work_, near.edge, middle, last).distance});
}

// Returns the largest distance of spokes and triangles from the surfaces with the vertex at its new sites, one for
// each use, mm.
double EdgeVertexRelocation::distance_from_surfaces(const EdgeVertexStar& bead,
                                                    const std::vector<ClassifiedMesh::VertexUse>& sites,
                                                    double where_none) const {
    const ClassifiedMesh& mesh = work_.mesh;
    geometry::Engine::Batch batch;
    double back = 0.0;
    for (std::size_t k = 0; k < bead.spokes.size(); ++k) {
        for (const int h : bead.spokes[k]) {
            const int face = mesh.face_of(ClassifiedMesh::triangle_of(h));
            const ClassifiedMesh::VertexUse& b = mesh.site(mesh.site_of(ClassifiedMesh::next(h)));
            const ClassifiedMesh::VertexUse& c = mesh.site(mesh.site_of(ClassifiedMesh::prev(h)));
            if (mesh.twin(h) >= 0) {
                add_edge_probes(work_, face, sites[k], b, batch);
            }
            add_triangle_probe(work_, face, sites[k], b, c, batch);
            back = std::max(back, backward_distance(work_, face, sites[k], b, c));
        }
    }
    return std::max(back, largest_distance(work_.session.ask(std::move(batch)), where_none));
}

// Whether the distance stays within the tolerance, or does not increase.
bool EdgeVertexRelocation::within_tolerance(const EdgeVertexStar& bead, const Place& place,
                                            const std::vector<ClassifiedMesh::VertexUse>& sites) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const double allowed = kNear * sizing_.tolerance;
    const ClassifiedMesh::Segment& near = mesh.segment(bead.near);
    const double from_curve = distance_from_curve(bead, {place.point, place.t});
    if (from_curve > allowed &&
        from_curve > distance_from_curve(bead, {mesh.vertex(near.vertices[1]).point, near.t[1]})) {
        return false;
    }
    const double from_surfaces = distance_from_surfaces(bead, sites, kFar);
    if (from_surfaces <= allowed) {
        return true;
    }
    std::vector<ClassifiedMesh::VertexUse> now;
    for (const std::vector<int>& around : bead.spokes) {
        now.push_back(mesh.site(mesh.site_of(around.front())));
    }
    return from_surfaces <= distance_from_surfaces(bead, now, 0.0);
}

bool EdgeVertexRelocation::aligned(const EdgeVertexStar& bead,
                                   const std::vector<ClassifiedMesh::VertexUse>& sites) const {
    const ClassifiedMesh& mesh = work_.mesh;
    double before = kAligned;
    double after = 1.0;
    for (std::size_t k = 0; k < bead.spokes.size(); ++k) {
        const Corner top{sites[k].point, sites[k].normal};
        for (const int h : bead.spokes[k]) {
            before = std::min(before, alignment(mesh, ClassifiedMesh::triangle_of(h)));
            after = std::min(after, alignment(top, corner_of(mesh, mesh.site_of(ClassifiedMesh::next(h))),
                                              corner_of(mesh, mesh.site_of(ClassifiedMesh::prev(h)))));
        }
    }
    return after >= before;
}

bool EdgeVertexRelocation::put(const EdgeVertexStar& bead, const Place& place, double bound, EditTransaction& undo) {
    if (!lengths_allowed(bead, place.point)) {
        return false;
    }
    ClassifiedMesh& mesh = work_.mesh;
    geometry::Engine::Batch batch;
    for (const ClassifiedMesh::SegmentUse& use : mesh.segment(bead.near).uses) {
        batch.push_back(Query::use_on_face(use.use, place.t));
    }
    std::vector<ClassifiedMesh::VertexUse> sites;
    for (const geometry::Answer& answer : work_.session.ask(std::move(batch))) {
        if (!answer.found()) {
            return false;
        }
        sites.push_back({-1, Vec2(answer.u, answer.v), answer.normal, place.point});
    }
    if (!aligned(bead, sites) || (sizing_.tolerance > 0.0 && !within_tolerance(bead, place, sites))) {
        return false;
    }
    undo.record_relocation(bead.near, bead.far, triangles_around(bead));
    const int vertex = mesh.add_vertex(place.point, {1, mesh.segment(bead.near).edge});
    std::vector<int> indices;
    for (ClassifiedMesh::VertexUse& site : sites) {
        site.vertex = vertex;
        indices.push_back(mesh.add_site(site));
    }
    std::vector<int> around;
    std::map<int, Exemption> in_corners;  // triangles at small input angles, which do not change
    for (std::size_t k = 0; k < bead.spokes.size(); ++k) {
        for (std::size_t i = 0; i < bead.spokes[k].size(); ++i) {
            const int t = ClassifiedMesh::triangle_of(bead.spokes[k][i]);
            const Exemption* exemption = bead.corners[k][i] >= 0 ? work_.exemption_of(t) : nullptr;
            if (exemption != nullptr) {
                in_corners[t] = *exemption;
            } else {
                around.push_back(t);
            }
        }
    }
    const std::optional<Exemption> reason = withdraw_exemptions(work_, around);
    work_.maxmin.replace_between(bead.near, bead.far, vertex, place.t, bead.spokes, indices);
    segments_at_.resize(static_cast<std::size_t>(mesh.vertex_count()), {-1, -1});
    segments_at_[static_cast<std::size_t>(vertex)] = {bead.near, bead.far};
    restore_exemptions(work_, around, bound, reason);
    for (auto& [t, exemption] : in_corners) {
        exemption.stamp = mesh.stamp(t);
        work_.exempt[t] = exemption;
    }
    return true;
}

std::vector<int> EdgeVertexRelocation::improve(int triangle, double bound, const std::function<double(double)>& enough,
                                               EditTransaction& undo) {
    if (sizing_.turn > 0.0 || sizing_.growth > 0.0) {
        return {};  // longer edges would have to satisfy the growth bounds of all neighbours
    }
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const auto bead = bead_at(work_.mesh.vertex_of(h), bound);
        if (!bead || !tried_.insert(state_key(work_.mesh, triangles_around(*bead))).second) {
            continue;
        }
        const auto now = angles_with(*bead, work_.mesh.vertex(work_.mesh.vertex_of(h)).point, {0.0, 0.0});
        std::vector<Place> places = places_for(*bead, {enough(now->beside), std::min(now->in_corners, bound)});
        places.resize(std::min(places.size(), OptimisationTuning::kMaxPositions));
        if (std::any_of(places.begin(), places.end(),
                        [&](const Place& place) { return put(*bead, place, bound, undo); })) {
            return triangles_around(*bead);
        }
    }
    return {};
}

}  // namespace mq::triangulate

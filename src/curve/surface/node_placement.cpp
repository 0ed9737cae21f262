// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/node_placement.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "base/tuning.h"
#include "curve/surface/tuning.h"
#include "elements/bezier/validity.h"

namespace mq::curve {

using elements::Barycentric;
using elements::Lattice;

namespace {

using geometry::Answer;
using geometry::Query;

/// Degree of the lattice on which the deviation is sampled: no order up to five has nodes there.
constexpr int kSampleDegree = 7;

}  // namespace

Placement::Placement(geometry::Session& session, CurvedSurface& surface)
    : session_(session), surface_(surface), distances_(session) {}

bool Placement::planar(int face) const {
    return std::strcmp(session_.topology().faces[static_cast<std::size_t>(face)].surface, "plane") == 0;
}

void Placement::place(const std::vector<int>& triangles) {
    std::set<elements::EdgeKey> seen;
    std::vector<EdgeTask> segments;
    std::vector<EdgeTask> inner;
    for (const int t : triangles) {
        const SurfaceTriangle& triangle = surface_.triangles[static_cast<std::size_t>(t)];
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = std::min(triangle.corners[k], triangle.corners[(k + 1) % 3]);
            const int b = std::max(triangle.corners[k], triangle.corners[(k + 1) % 3]);
            if (surface_.shapes.has_edge(a, b) || !seen.insert(pair_key(a, b)).second) {
                continue;
            }
            if (surface_.segment(a, b) != nullptr) {
                segments.push_back({a, b, triangle.face});
            } else if (!planar(triangle.face)) {
                inner.push_back({a, b, triangle.face});
            }
        }
    }
    if (surface_.shapes.order() > 1) {
        place_segments(segments);
        place_inner_edges(inner);
    }
    if (surface_.shapes.order() > 2) {
        place_faces(triangles, false);
    }
    measure(triangles);
    if (surface_.shapes.order() > 2) {
        improve_faces(triangles);
    }
}

/// The branch of the vertex' (u, v) nearest to `near`.
Vec2 Placement::unwrapped(int vertex, int face, const Vec2& near) const {
    Vec2 uv = *surface_.uv_of(vertex, face);
    const auto& period = session_.topology().faces[static_cast<std::size_t>(face)].period;
    for (Eigen::Index i = 0; i < 2; ++i) {
        const double p = period[static_cast<std::size_t>(i)];
        if (p > 0.0) {
            uv[i] += p * std::round((near[i] - uv[i]) / p);
        }
    }
    return uv;
}

void Placement::resolve_free(int vertex, int face, const Vec2& other, Vec2& uv) const {
    const auto found = surface_.free_parameter.find(CurvedSurface::key(vertex, face));
    if (found != surface_.free_parameter.end()) {
        uv[found->second] = other[found->second];
    }
}

std::array<Vec2, 3> Placement::corner_uv(const SurfaceTriangle& triangle) const {
    const auto free = [&](int v) { return surface_.free_parameter.count(CurvedSurface::key(v, triangle.face)) > 0; };
    std::size_t first = 0;
    while (first < 2 && free(triangle.corners[first])) {
        ++first;
    }
    std::array<Vec2, 3> uv;
    uv[first] = *surface_.uv_of(triangle.corners[first], triangle.face);
    for (std::size_t k = 0; k < 3; ++k) {
        uv[k] = k == first ? uv[k] : unwrapped(triangle.corners[k], triangle.face, uv[first]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = (k + 1) % 3;
        const std::size_t b = (k + 2) % 3;
        const Vec2 other = free(triangle.corners[a])   ? uv[b]
                           : free(triangle.corners[b]) ? uv[a]
                                                       : 0.5 * (uv[a] + uv[b]);
        resolve_free(triangle.corners[k], triangle.face, other, uv[k]);
    }
    return uv;
}

/// The curved triangles whose corners lie on their faces at their (u, v). The others are blended from their edges: in a
/// plane these lie in it, and at a gap they leave the face.
std::vector<Placement::FaceTask> Placement::triangles_on_faces(const std::vector<int>& triangles) {
    std::vector<FaceTask> curved;
    std::vector<Ends> sides;
    for (const int t : triangles) {
        const SurfaceTriangle& triangle = surface_.triangles[static_cast<std::size_t>(t)];
        if (planar(triangle.face)) {
            continue;
        }
        curved.push_back({t, corner_uv(triangle)});
        const std::array<Vec2, 3>& uv = curved.back().uv;
        const auto corner = [&](std::size_t k) { return Query::face_point(triangle.face, uv[k].x(), uv[k].y()); };
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            sides.push_back({triangle.corners[k], triangle.corners[next], corner(k), corner(next)});
        }
    }
    const std::vector<Gaps> open = gaps(sides);
    std::vector<FaceTask> result;
    for (std::size_t i = 0; i < curved.size(); ++i) {
        if (open[3 * i].none && open[3 * i + 1].none && open[3 * i + 2].none) {
            result.push_back(curved[i]);
        }
    }
    return result;
}

void Placement::place_faces(const std::vector<int>& triangles, bool by_parameters) {
    const Lattice& lattice = Lattice::of(2, surface_.shapes.order());
    for (const int t : triangles) {
        surface_.shapes.forget_face(surface_.triangles[static_cast<std::size_t>(t)].corners);
    }
    const std::vector<FaceTask> tasks = triangles_on_faces(triangles);
    std::vector<Query> batch;
    std::vector<std::vector<Vec3>> all;
    for (const auto& [t, uv] : tasks) {
        const SurfaceTriangle& triangle = surface_.triangles[static_cast<std::size_t>(t)];
        std::vector<Vec3> control;
        surface_.shapes.triangle(triangle.corners, control);
        all.push_back(elements::bezier_to_nodes(lattice, control));
        for (int i = 0; i < lattice.size(); ++i) {
            if (lattice.carriers(i) < 3) {
                continue;
            }
            const Barycentric b = lattice.node(i);
            const Vec2 guess = b[0] * uv[0] + b[1] * uv[1] + b[2] * uv[2];
            batch.push_back(by_parameters ? Query::face_point(triangle.face, guess.x(), guess.y())
                                          : Query::face_nearest(triangle.face, all.back()[static_cast<std::size_t>(i)],
                                                                guess.x(), guess.y()));
        }
    }
    const auto answers = session_.ask(std::move(batch));
    std::size_t next = 0;
    for (std::size_t k = 0; k < tasks.size(); ++k) {
        bool found = true;
        for (int i = 0; i < lattice.size(); ++i) {
            if (lattice.carriers(i) == 3) {
                found = found && answers[next].found();
                all[k][static_cast<std::size_t>(i)] = answers[next++].point;
            }
        }
        if (!found) {
            continue;  // the shape of the face is blended from its edges
        }
        surface_.shapes.set_inside(surface_.triangles[static_cast<std::size_t>(tasks[k].triangle)].corners,
                                   elements::nodes_to_bezier(lattice, all[k]));
    }
}

/// Places the inner nodes of poor triangles in the other of the two ways, and keeps this if the quality is better.
void Placement::improve_faces(const std::vector<int>& triangles) {
    std::vector<int> poor;
    std::vector<double> before;
    for (const int t : triangles) {
        const SurfaceTriangle& triangle = surface_.triangles[static_cast<std::size_t>(t)];
        if (triangle.quality < SurfaceTuning::kWorthComparing && !planar(triangle.face)) {
            poor.push_back(t);
            before.push_back(triangle.quality);
        }
    }
    place_faces(poor, true);
    measure(poor);
    std::vector<int> worse;
    for (std::size_t i = 0; i < poor.size(); ++i) {
        if (surface_.triangles[static_cast<std::size_t>(poor[i])].quality < before[i]) {
            worse.push_back(poor[i]);
        }
    }
    place_faces(worse, false);
    measure(worse);
}

/// The CAD normal at a point slightly inside the triangle from a corner.
Vec3 Placement::normal_inside(const SurfaceTriangle& triangle, int corner, geometry::Answerer& answerer) const {
    const std::array<Vec2, 3> uv = corner_uv(triangle);
    const Vec2 at = (1.0 - SurfaceTuning::kInsideCorner) * uv[static_cast<std::size_t>(corner)] +
                    SurfaceTuning::kInsideCorner / 3.0 * (uv[0] + uv[1] + uv[2]);
    return answerer.answer(Query::face_point(triangle.face, at.x(), at.y())).normal;
}

/// The CAD normals at the nodes of a triangle, as the CAD face has them.
std::vector<Vec3> Placement::normals_at(const SurfaceTriangle& triangle, const std::vector<Vec3>& control,
                                        geometry::Answerer& answerer) const {
    const Lattice& lattice = Lattice::of(2, surface_.shapes.order());
    if (planar(triangle.face)) {
        const auto& face = session_.topology().faces[static_cast<std::size_t>(triangle.face)];
        const Answer answer = answerer.answer(Query::face_point(triangle.face, face.low[0], face.low[1]));
        return std::vector<Vec3>(static_cast<std::size_t>(lattice.size()), answer.normal);
    }
    const std::vector<Vec3> nodes = elements::bezier_to_nodes(lattice, control);
    const std::array<Vec2, 3> uv = corner_uv(triangle);
    const auto off = [&](int v) { return surface_.off_cad.count(v) > 0; };
    const bool loose = std::any_of(triangle.corners.begin(), triangle.corners.end(), off);
    std::vector<Vec3> normals;
    for (int i = 0; i < lattice.size(); ++i) {
        const Barycentric b = lattice.node(i);
        const Vec2 guess = b[0] * uv[0] + b[1] * uv[1] + b[2] * uv[2];
        const Query query =
            lattice.carriers(i) == 1 && !loose
                ? Query::face_point(triangle.face, guess.x(), guess.y())
                : Query::face_nearest(triangle.face, nodes[static_cast<std::size_t>(i)], guess.x(), guess.y());
        normals.push_back(answerer.answer(query).normal);
    }
    return normals;
}

double Placement::quality_of(const SurfaceTriangle& triangle, geometry::Answerer& answerer) const {
    const Lattice& lattice = Lattice::of(2, surface_.shapes.order());
    std::vector<Vec3> control;
    surface_.shapes.triangle(triangle.corners, control);
    const double sign = surface_.face_sign[static_cast<std::size_t>(triangle.face)];
    std::vector<Vec3> normals = normals_at(triangle, control, answerer);
    Vec3 sum = Vec3::Zero();
    for (Vec3& normal : normals) {
        normal *= sign;
        sum += normal;
    }
    // At poles there is no normal, and in corners that are collapsed to within their tolerance the normal is noise.
    const Vec3 mean = sum.normalized();
    for (Vec3& normal : normals) {
        if (normal.isZero()) {
            normal = mean;
        }
    }
    for (int corner = 0; corner < 3; ++corner) {
        Vec3& normal = normals[static_cast<std::size_t>(lattice.corner(corner))];
        if (normal.dot(mean) <= 0.0) {
            normal = sign * normal_inside(triangle, corner, answerer);
        }
    }
    return elements::certified_ratio(elements::normal_component(lattice, control, normals));
}

void Placement::measure(const std::vector<int>& triangles) {
    const auto work = [&](geometry::Answerer& answerer, std::size_t from, std::size_t to) {
        for (std::size_t k = from; k < to; ++k) {
            SurfaceTriangle& triangle = surface_.triangles[static_cast<std::size_t>(triangles[k])];
            triangle.quality = quality_of(triangle, answerer);
        }
    };
    session_.for_chunks(triangles.size(), work,
                        static_cast<std::size_t>(Lattice::of(2, surface_.shapes.order()).size()));
}

std::vector<double> Placement::deviations(const std::vector<int>& triangles) {
    const Lattice& lattice = Lattice::of(2, surface_.shapes.order());
    const Lattice& samples = Lattice::of(2, kSampleDegree);
    std::vector<geometry::TrimmedFaceDistances::Place> places;
    std::vector<Vec3> control;
    for (const int t : triangles) {
        const SurfaceTriangle& triangle = surface_.triangles[static_cast<std::size_t>(t)];
        surface_.shapes.triangle(triangle.corners, control);
        const std::array<Vec2, 3> uv = corner_uv(triangle);
        const auto add = [&](const Barycentric& b) {
            places.push_back({triangle.face, elements::value(lattice, control, b),
                              Vec2(b[0] * uv[0] + b[1] * uv[1] + b[2] * uv[2])});
        };
        for (int i = 0; i < samples.size(); ++i) {
            if (samples.carriers(i) > 1) {
                add(samples.node(i));
            }
        }
        // Chords are farthest from the CAD in the middle, at which curved edges may have a node.
        for (const Barycentric& b : {Barycentric{0.5, 0.5, 0.0, 0.0}, {0.0, 0.5, 0.5, 0.0}, {0.5, 0.0, 0.5, 0.0}}) {
            if (lattice.degree() == 1) {
                add(b);
            }
        }
    }
    std::vector<double> result = distances_.measure(places);
    result.erase(std::remove_if(result.begin(), result.end(), [](double d) { return d < 0.0; }), result.end());
    return result;
}

bool Placement::on_edge(int vertex, int edge, double t_from, double t_to, double allowed, double& t, Vec3& point) {
    // Tolerance as a fraction of the size: vertices of the triangulation are rounded to single precision. Twice the
    // tolerance of an edge is the distance of two curves that represent it.
    constexpr double kSinglePrecision = 4e-7;
    const geometry::Topology& topology = session_.topology();
    const double tolerance = std::max(kSinglePrecision * topology.box.largest_side(),
                                      2.0 * topology.edges[static_cast<std::size_t>(edge)].tolerance);
    const double low = std::min(t_from, t_to);
    const double high = std::max(t_from, t_to);
    // The curve may come near the vertex more than once.
    std::vector<Query> batch;
    for (int k = 0; k < kMostRounds; ++k) {
        const Vec3& p = surface_.shapes.vertices[static_cast<std::size_t>(vertex)].point;
        batch.push_back(Query::edge_nearest(edge, p, low + (k + 0.5) / kMostRounds * (high - low), low, high));
    }
    double nearest = std::max(tolerance, allowed);
    bool found = false;
    for (const Answer& answer : session_.ask(std::move(batch))) {
        const bool between = answer.t > low && answer.t < high;
        if (answer.found() && between && answer.distance <= nearest) {
            nearest = answer.distance;
            t = answer.t;
            point = answer.point;
            found = true;
        }
    }
    return found;
}

void Placement::set_uv_on_edge(int vertex, int edge, double t) {
    for (const int use : session_.topology().edges[static_cast<std::size_t>(edge)].uses) {
        const Answer on = session_.ask(Query::use_on_face(use, t));
        if (on.found()) {
            const int face = session_.topology().uses[static_cast<std::size_t>(use)].face;
            surface_.uv[CurvedSurface::key(vertex, face)] = Vec2(on.u, on.v);
        }
    }
}

Placement::Middle Placement::middle_of(int a, int b) {
    Middle middle;
    const int low = std::min(a, b);
    const int high = std::max(a, b);
    const Segment* segment = surface_.segment(a, b);
    const std::vector<int> beside = surface_.triangles_of_edge(a, b);
    if (segment != nullptr) {
        const Answer answer = session_.ask(Query::edge_middle(segment->edge, segment->t_low, segment->t_high));
        middle.found = answer.found();
        middle.t = answer.t;
        middle.vertex = {answer.point, {1, segment->edge}};
        for (const int use : session_.topology().edges[static_cast<std::size_t>(segment->edge)].uses) {
            const Answer on = session_.ask(Query::use_on_face(use, answer.t));
            middle.uv.emplace_back(session_.topology().uses[static_cast<std::size_t>(use)].face, Vec2(on.u, on.v));
            middle.found = middle.found && on.found();
        }
        return middle;
    }
    const int face = surface_.triangles[static_cast<std::size_t>(beside.front())].face;
    Vec2 from = *surface_.uv_of(low, face);
    Vec2 to = unwrapped(high, face, from);
    resolve_free(low, face, to, from);
    resolve_free(high, face, from, to);
    const Vec2 guess = 0.5 * (from + to);
    std::vector<Vec3> control{surface_.shapes.vertices[static_cast<std::size_t>(low)].point};
    for (const Vec3& p : surface_.shapes.edge_inner(low, high)) {
        control.push_back(p);
    }
    control.push_back(surface_.shapes.vertices[static_cast<std::size_t>(high)].point);
    const Vec3 on_curve = elements::value(Lattice::of(1, surface_.shapes.order()), control, {0.5, 0.5, 0.0, 0.0});
    const Answer answer = session_.ask(Query::face_nearest(face, on_curve, guess.x(), guess.y()));
    middle.found = answer.found();
    middle.vertex = {answer.point, {2, face}};
    middle.uv.emplace_back(face, Vec2(answer.u, answer.v));
    return middle;
}

}  // namespace mq::curve

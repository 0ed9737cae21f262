// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/segment_split.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/predicates.h"
#include "triangulate/corner_angle.h"
#include "triangulate/fold.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Query;
using mesh::SurfaceMesh;

constexpr double kAcute = M_PI / 2.0;
constexpr double kNarrow = M_PI / 3.0;
// The innermost shell is this much smaller than the distance to the nearest thing that is not part of the corner.
constexpr double kRoom = 0.25;

}  // namespace

SegmentSplitter::SegmentSplitter(Workspace& work) : work_(work) {
    measure_room();
}

// For every CAD node: the nearest vertex of S_C on a CAD edge or node that is not part of the edges meeting in it, and
// the shortest piece that leaves it.
void SegmentSplitter::measure_room() {
    const SurfaceMesh& mesh = work_.mesh;
    const int n = mesh.vertex_count();
    innermost_.assign(n, 0.0);
    std::map<int, std::set<int>> edges_at;
    std::map<int, double> room;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        for (int end = 0; end < 2 && !mesh.segment(s).uses.empty(); ++end) {
            const int v = mesh.segment(s).vertices[end];
            if (narrowest_corner(mesh, s, end).angle < kAcute) {
                room.emplace(v, 1e300);
            }
            edges_at[v].insert(mesh.segment(s).edge);
        }
    }
    for (auto& [node, radius] : room) {
        const std::set<int>& own = edges_at[node];
        for (int v = 0; v < n; ++v) {
            const auto& entity = mesh.vertex(v).entity;
            const bool counts = entity[0] == 0 ? v != node : entity[0] == 1 && own.count(entity[1]) == 0;
            if (counts) {
                radius = std::min(radius, (mesh.vertex(v).point - mesh.vertex(node).point).norm());
            }
        }
    }
    for (int s = 0; s < mesh.segment_count(); ++s) {
        for (const int v : mesh.segment(s).vertices) {
            if (const auto found = room.find(v); found != room.end()) {
                found->second = std::min(found->second, chord(s));
            }
        }
    }
    for (const auto& [node, radius] : room) {
        innermost_[node] = kRoom * radius;
    }
}

double SegmentSplitter::chord(int segment) const {
    const auto& v = work_.mesh.segment(segment).vertices;
    return (work_.mesh.vertex(v[1]).point - work_.mesh.vertex(v[0]).point).norm();
}

bool SegmentSplitter::encroached(int segment) const {
    for (const SurfaceMesh::SegmentUse& use : work_.mesh.segment(segment).uses) {
        const int h = use.half_edge;
        if (mq::encroached(work_.mesh.point_of(h), work_.mesh.point_of(SurfaceMesh::next(h)),
                           work_.mesh.point_of(SurfaceMesh::prev(h)))) {
            return true;
        }
    }
    return false;
}

SegmentSplitter::Shell SegmentSplitter::shell_of(int segment) const {
    const NarrowCorner corners[2] = {narrowest_corner(work_.mesh, segment, 0), narrowest_corner(work_.mesh, segment, 1)};
    const int end = corners[1].angle < corners[0].angle ? 1 : 0;
    if (corners[end].angle >= kAcute) {
        return {};
    }
    return {end, std::exp2(std::round(std::log2(0.5 * chord(segment))))};
}

bool SegmentSplitter::frozen(int segment, int* corner_vertex) const {
    for (int end = 0; end < 2; ++end) {
        const int v = work_.mesh.segment(segment).vertices[end];
        if (v < static_cast<int>(innermost_.size()) && chord(segment) <= innermost_[v] &&
            narrowest_corner(work_.mesh, segment, end).angle < kNarrow) {
            if (corner_vertex != nullptr) {
                *corner_vertex = v;
            }
            return true;
        }
    }
    return false;
}

bool SegmentSplitter::in_lens(int segment, const Vec3& p) const {
    const auto& v = work_.mesh.segment(segment).vertices;
    const Vec3 a = work_.mesh.vertex(v[0]).point - p;
    const Vec3 b = work_.mesh.vertex(v[1]).point - p;
    return a.dot(b) < -0.5 * a.norm() * b.norm();
}

void SegmentSplitter::request(int segment) {
    waiting_.resize(std::max<std::size_t>(waiting_.size(), work_.mesh.segment_count()), 0);
    if (!waiting_[segment] && !refused(segment) && !frozen(segment)) {
        waiting_[segment] = 1;
        pending_.push_back(segment);
    }
}

void SegmentSplitter::refuse(int segment) {
    refused_.resize(std::max<std::size_t>(refused_.size(), work_.mesh.segment_count()), 0);
    refused_[segment] = 1;
}

void SegmentSplitter::run(std::vector<int>& touched) {
    while (!pending_.empty() && !work_.over_budget()) {
        work_.progress.check();
        std::vector<int> now;
        now.swap(pending_);
        for (const int s : now) {
            waiting_[s] = 0;
        }
        const std::size_t before = touched.size();
        split_batch(now, touched);
        request_encroached_around(std::vector<int>(touched.begin() + before, touched.end()));
    }
}

void SegmentSplitter::request_encroached_around(const std::vector<int>& triangles) {
    for (const int t : triangles) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const int s = work_.mesh.segment_of(h);
            if (s >= 0 && encroached(s)) {
                request(s);
            }
        }
    }
}

Query SegmentSplitter::place_query(int segment) const {
    const SurfaceMesh::Segment& s = work_.mesh.segment(segment);
    const Shell shell = shell_of(segment);
    if (shell.end < 0) {
        return Query::edge_middle(s.edge, s.t[0], s.t[1]);
    }
    return Query::edge_at_distance(s.edge, s.t[shell.end], s.t[1 - shell.end], shell.radius);
}

void SegmentSplitter::split_batch(const std::vector<int>& segments, std::vector<int>& touched) {
    geometry::Engine::Batch batch;
    for (const int s : segments) {
        batch.push_back(place_query(s));
    }
    geometry::Engine::Answers places = work_.session.ask(std::move(batch));
    geometry::Engine::Batch on_faces;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const SurfaceMesh::Segment& s = work_.mesh.segment(segments[i]);
        if (!places[i].found()) {  // a curve that leaves the shell and comes back: its middle will do
            places[i] = work_.session.ask(Query::edge_middle(s.edge, s.t[0], s.t[1]));
        }
        for (const SurfaceMesh::SegmentUse& use : s.uses) {
            on_faces.push_back(Query::use_on_face(use.use, places[i].t));
        }
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(on_faces));
    const Answer* next = answers.data();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const std::size_t uses = work_.mesh.segment(segments[i]).uses.size();
        if (!places[i].found() || !split(segments[i], places[i], next, touched)) {
            refuse(segments[i]);
        }
        next += uses;
    }
}

// The new vertex must see the apex from its own side of the apex's two edges. Where it does not (a curve that bulges
// past them), the edge in the way is swapped first.
bool SegmentSplitter::make_room(int segment, std::size_t use, const Vec3& point, const Vec3& normal,
                                std::vector<int>& touched) {
    SurfaceMesh& mesh = work_.mesh;
    for (int tries = 0; tries < 8; ++tries) {
        const int h = mesh.segment(segment).uses[use].half_edge;
        const Corner a = corner_of(mesh, mesh.site_of(h));
        const Corner b = corner_of(mesh, mesh.site_of(SurfaceMesh::next(h)));
        const Corner c = corner_of(mesh, mesh.site_of(SurfaceMesh::prev(h)));
        const Corner p{point, normal};
        const double before = std::min(kAligned, alignment(a, b, c));
        const bool near_bad = alignment(a, p, c) < std::min(before, 0.1);
        const bool far_bad = alignment(p, b, c) < std::min(before, 0.1);
        if (!near_bad && !far_bad) {
            return true;
        }
        const int blocking = near_bad ? SurfaceMesh::prev(h) : SurfaceMesh::next(h);
        const int g = mesh.twin(blocking);
        if ((near_bad && far_bad) || g < 0) {
            return false;
        }
        const Corner d = corner_of(mesh, mesh.site_of(SurfaceMesh::prev(g)));
        const Corner& from = near_bad ? c : b;
        const Corner& to = near_bad ? a : c;
        const Corner& apex = near_bad ? b : a;
        if (mesh.vertex_of(SurfaceMesh::prev(g)) == mesh.vertex_of(SurfaceMesh::prev(blocking)) ||
            std::min(alignment(from, d, apex), alignment(d, to, apex)) < 0.1) {
            return false;
        }
        work_.maxmin.forget(mesh.vertex_of(blocking), mesh.vertex_of(SurfaceMesh::next(blocking)));
        mesh.swap(blocking);
        const int t = SurfaceMesh::triangle_of(blocking);
        work_.maxmin.remember(mesh.vertex_of(3 * t + 1), mesh.vertex_of(3 * t + 2));
        touched.push_back(t);
        touched.push_back(SurfaceMesh::triangle_of(g));
    }
    return false;
}

bool SegmentSplitter::split(int segment, const Answer& place, const Answer* on_faces, std::vector<int>& touched) {
    SurfaceMesh& mesh = work_.mesh;
    const SurfaceMesh::Segment old = mesh.segment(segment);
    const Vec3 point = work_.grid.snap(place.point);
    const double least = work_.shortest_allowed();
    const double low = std::min(old.t[0], old.t[1]);
    const double high = std::max(old.t[0], old.t[1]);
    if (place.t <= low || place.t >= high || (point - mesh.vertex(old.vertices[0]).point).norm() < least ||
        (point - mesh.vertex(old.vertices[1]).point).norm() < least) {
        return false;
    }
    for (std::size_t k = 0; k < old.uses.size(); ++k) {
        if (!on_faces[k].found() || !make_room(segment, k, point, on_faces[k].normal, touched)) {
            return false;
        }
    }
    const int vertex = mesh.add_vertex(point, {1, old.edge});
    std::vector<int> sites;
    for (std::size_t k = 0; k < old.uses.size(); ++k) {
        sites.push_back(mesh.add_site({vertex, Vec2(on_faces[k].u, on_faces[k].v), on_faces[k].normal}));
    }
    work_.maxmin.forget(old.vertices[0], old.vertices[1]);
    const int far = mesh.split_segment(segment, vertex, place.t, sites);
    work_.maxmin.remember(old.vertices[0], vertex);
    work_.maxmin.remember(vertex, old.vertices[1]);
    work_.depth[segment] += 1;
    work_.depth.push_back(work_.depth[segment]);
    std::vector<int> stack;
    for (const int s : {segment, far}) {
        for (const SurfaceMesh::SegmentUse& use : mesh.segment(s).uses) {
            const int t = SurfaceMesh::triangle_of(use.half_edge);
            touched.push_back(t);
            stack.insert(stack.end(), {3 * t, 3 * t + 1, 3 * t + 2});
            if (s == segment) {  // the edge from the new vertex to the apex is seen from both halves: count it once
                work_.maxmin.remember(vertex, mesh.vertex_of(SurfaceMesh::prev(use.half_edge)));
            }
        }
    }
    work_.maxmin.restore(stack, touched);
    return true;
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/chord.h"

#include <algorithm>

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Query;
using mesh::SurfaceMesh;

constexpr int kMaxRounds = 60;

std::uint64_t edge_key(const SurfaceMesh& mesh, int h) {
    const int a = mesh.vertex_of(h);
    const int b = mesh.vertex_of(SurfaceMesh::next(h));
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
}

std::uint64_t triangle_key(const SurfaceMesh& mesh, int t) {
    return (static_cast<std::uint64_t>(t) << 32) | mesh.stamp(t);
}

double length_of(const SurfaceMesh& mesh, int h) {
    return (mesh.point_of(SurfaceMesh::next(h)) - mesh.point_of(h)).norm();
}

Candidate centroid_site(const SurfaceMesh& mesh, int t) {
    Candidate c = edge_middle_site(mesh, 3 * t);
    const int apex = 3 * t + 2;
    c.point = (2.0 * c.point + mesh.point_of(apex)) / 3.0;
    c.uv = (2.0 * c.uv + mesh.site(mesh.site_of(apex)).uv) / 3.0;
    return c;
}

Query nearest_on_surface(const Workspace& work, const Candidate& c) {
    return Query::face_nearest(work.mesh.face_of(c.triangle), work.grid.to_part(c.point), c.uv.x(), c.uv.y());
}

Query nearest_on_curve(const Workspace& work, int segment) {
    const SurfaceMesh::Segment& s = work.mesh.segment(segment);
    const Vec3 middle = 0.5 * (work.mesh.vertex(s.vertices[0]).point + work.mesh.vertex(s.vertices[1]).point);
    return Query::edge_nearest(s.edge, work.grid.to_part(middle), 0.5 * (s.t[0] + s.t[1]), s.t[0], s.t[1]);
}

int longest_side(const SurfaceMesh& mesh, int t) {
    int best = 3 * t;
    for (int h = 3 * t + 1; h < 3 * t + 3; ++h) {
        best = length_of(mesh, h) > length_of(mesh, best) ? h : best;
    }
    return best;
}

}  // namespace

double ChordRefiner::excess_of_edge(double chord, int half_edge) const {
    const double worst = excess(chord);
    return bounds_.any() ? std::max(worst, length_of(work_.mesh, half_edge) / bounds_.of(work_.mesh, half_edge))
                         : worst;
}

void ChordRefiner::measure_segments(std::vector<Site>& found) {
    geometry::Engine::Batch batch;
    std::vector<int> sides;
    for (int s = 0; s < work_.mesh.segment_count(); ++s) {
        const auto& uses = work_.mesh.segment(s).uses;
        if (!uses.empty() && !segments_.refused(s) &&
            passed_edges_.count(edge_key(work_.mesh, uses[0].half_edge)) == 0) {
            batch.push_back(nearest_on_curve(work_, s));
            sides.push_back(uses[0].half_edge);
        }
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(batch));
    Pace pace(work_.progress);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        pace.step();
        const double chord = answers[i].found() ? answers[i].distance : 0.0;
        const double e = excess_of_edge(chord, sides[i]);
        if (e > 1.0) {
            found.push_back({sides[i], 0, e, {}});
        } else {
            passed_edges_.insert(edge_key(work_.mesh, sides[i]));
        }
    }
}

void ChordRefiner::measure_edges(std::vector<Site>& found) {
    geometry::Engine::Batch batch;
    std::vector<Site> sites;
    Pace pace(work_.progress);
    for (int h = 0; h < work_.mesh.half_edge_count(); ++h) {
        pace.step();
        if (work_.mesh.twin(h) > h && passed_edges_.count(edge_key(work_.mesh, h)) == 0) {
            sites.push_back({h, work_.mesh.stamp(h / 3), 0.0, edge_middle_site(work_.mesh, h)});
            batch.push_back(nearest_on_surface(work_, sites.back().candidate));
        }
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(batch));
    for (std::size_t i = 0; i < sites.size(); ++i) {
        pace.step();
        const double chord = answers[i].found() ? answers[i].distance : 0.0;
        sites[i].excess = excess_of_edge(chord, sites[i].half_edge);
        if (sites[i].excess > 1.0) {
            found.push_back(sites[i]);
        } else {
            passed_edges_.insert(edge_key(work_.mesh, sites[i].half_edge));
        }
    }
}

void ChordRefiner::measure_triangles(std::vector<Site>& found) {
    geometry::Engine::Batch batch;
    std::vector<int> triangles;
    Pace pace(work_.progress);
    for (int t = 0; t < work_.mesh.triangle_count(); ++t) {
        pace.step();
        if (passed_triangles_.count(triangle_key(work_.mesh, t)) == 0) {
            triangles.push_back(t);
            batch.push_back(nearest_on_surface(work_, centroid_site(work_.mesh, t)));
        }
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(batch));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        pace.step();
        const int t = triangles[i];
        const double e = excess(answers[i].found() ? answers[i].distance : 0.0);
        passed_triangles_.insert(triangle_key(work_.mesh, t));
        if (e > 1.0) {
            const int h = longest_side(work_.mesh, t);
            found.push_back({h, work_.mesh.stamp(t), e, edge_middle_site(work_.mesh, h)});
        }
    }
}

std::vector<ChordRefiner::Site> ChordRefiner::violations() {
    std::vector<Site> found;
    measure_segments(found);
    if (found.empty()) {
        measure_edges(found);
    }
    if (found.empty() && tolerance_ > 0.0) {
        measure_triangles(found);
    }
    std::stable_sort(found.begin(), found.end(), [](const Site& a, const Site& b) { return a.excess > b.excess; });
    return found;
}

bool ChordRefiner::run() {
    changed_ = false;
    for (int round = 0; round < kMaxRounds && !work_.over_budget(); ++round) {
        work_.progress.check();
        const int before = work_.mesh.triangle_count();
        const std::vector<Site> sites = violations();
        work_.progress.check();
        if (sites.empty()) {
            break;
        }
        split(sites);
        if (work_.mesh.triangle_count() == before) {
            break;
        }
        changed_ = true;
    }
    return changed_;
}

void ChordRefiner::split(const std::vector<Site>& sites) {
    std::vector<Candidate> candidates;
    std::vector<const Site*> inner;
    for (const Site& site : sites) {
        const int s = work_.mesh.segment_of(site.half_edge);
        if (s >= 0) {
            segments_.request(s, true);
        } else {
            candidates.push_back(site.candidate);
            inner.push_back(&site);
        }
    }
    const auto points = surface_points(work_, candidates);
    Pace pace(work_.progress);
    for (std::size_t i = 0; i < inner.size() && !work_.over_budget(); ++i) {
        pace.step();
        split_one(*inner[i], points[i]);
    }
    segments_.run(touched_);
    touched_.clear();
}

void ChordRefiner::split_one(const Site& site, const std::optional<SurfacePoint>& p) {
    const int h = site.half_edge;
    if (!p || work_.mesh.stamp(h / 3) != site.stamp || work_.mesh.twin(h) < 0) {
        return;
    }
    bool split_segment = false;
    for (const int s : look_around(work_.mesh, h / 3, p->point).encroached) {
        if (!segments_.refused(s) && !segments_.frozen(s)) {
            segments_.request(s);
            split_segment = true;
        }
    }
    if (!split_segment && insert_vertex(work_, h / 3, *p, touched_, kAlignedAtLast)) {
        passed_edges_.insert(edge_key(work_.mesh, h));  // refused: it cannot be split here
    }
}

ChordHeight measure_chord_height(Workspace& work) {
    constexpr std::size_t kChunk = 65536;
    ChordHeight worst;
    geometry::Engine::Batch batch;
    std::vector<int> triangles;
    std::vector<Vec3> points;
    const auto flush = [&] {
        const geometry::Engine::Answers answers = work.session.ask(std::move(batch));
        for (std::size_t i = 0; i < answers.size(); ++i) {
            if (answers[i].found() && (worst.triangle < 0 || answers[i].distance > worst.distance)) {
                worst = {answers[i].distance, triangles[i], points[i]};
            }
        }
        batch.clear();
        triangles.clear();
        points.clear();
        work.progress.check();
    };
    const auto add = [&](const Query& q, int triangle, const Vec3& point) {
        batch.push_back(q);
        triangles.push_back(triangle);
        points.push_back(work.grid.to_part(point));
        if (batch.size() == kChunk) {
            flush();
        }
    };
    for (int s = 0; s < work.mesh.segment_count(); ++s) {
        const auto& uses = work.mesh.segment(s).uses;
        if (!uses.empty()) {
            const int h = uses.front().half_edge;
            add(nearest_on_curve(work, s), SurfaceMesh::triangle_of(h), edge_middle_site(work.mesh, h).point);
        }
    }
    for (int h = 0; h < work.mesh.half_edge_count(); ++h) {
        if (work.mesh.twin(h) > h) {
            const Candidate middle = edge_middle_site(work.mesh, h);
            add(nearest_on_surface(work, middle), SurfaceMesh::triangle_of(h), middle.point);
        }
    }
    for (int t = 0; t < work.mesh.triangle_count(); ++t) {
        const Candidate centroid = centroid_site(work.mesh, t);
        add(nearest_on_surface(work, centroid), t, centroid.point);
    }
    flush();
    return worst;
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/insertion.h"

#include <algorithm>
#include <cmath>

#include "base/predicates.h"
#include "triangulate/cavity.h"
#include "triangulate/corner_angle.h"
#include "triangulate/side_length.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Query;
using mesh::SurfaceMesh;

// The new triangle on the shortest edge gets an angle this much above the bound, so that rounding does not spoil it.
constexpr double kOffCentreSlack = 1.05;
// Where the surface leaves the triangle's plane by more than this part of the way, the off-centre means nothing.
constexpr double kMaxLift = 0.5;
constexpr int kMaxWalk = 100;
constexpr std::size_t kMaxVisit = 400;

struct Weights {
    double w[3];
};

Candidate weighted_site(const SurfaceMesh& mesh, int triangle, const Weights& weights) {
    Candidate c;
    c.triangle = triangle;
    for (int i = 0; i < 3; ++i) {
        const int h = 3 * triangle + i;
        c.point += weights.w[i] * mesh.point_of(h);
        c.uv += weights.w[i] * mesh.site(mesh.site_of(h)).uv;
        c.reach = std::max(c.reach, side_length(mesh, h));
    }
    return c;
}

// Barycentric weights of the circumcentre, yet to be divided by their sum: not above 0 for degenerate triangles.
Weights circumcentre_shares(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = (c - b).squaredNorm();
    const double lb = (a - c).squaredNorm();
    const double lc = (b - a).squaredNorm();
    const double wa = la * (lb + lc - la);
    const double wb = lb * (lc + la - lb);
    const double wc = lc * (la + lb - lc);
    return {{wa, wb, wc}};
}

Weights circumcentre(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto [wa, wb, wc] = circumcentre_shares(a, b, c).w;
    const double sum = wa + wb + wc;
    return {{wa / sum, wb / sum, wc / sum}};
}

// Of the ball around the circumcentre. The power of a point is linear but for its square, and vanishes at the corners:
// seen from p, with the centre as the sum of w x over the corners x, that of p is 2 |centre|^2 - sum of w |x|^2. Here
// both are times the square of the sum of the weights, which spares the division.
bool in_circumsphere(const SurfaceMesh& mesh, int triangle, const Vec3& p) {
    const Vec3 a = mesh.point_of(3 * triangle) - p;
    const Vec3 b = mesh.point_of(3 * triangle + 1) - p;
    const Vec3 c = mesh.point_of(3 * triangle + 2) - p;
    const auto [wa, wb, wc] = circumcentre_shares(a, b, c).w;
    const double squares = wa * a.squaredNorm() + wb * b.squaredNorm() + wc * c.squaredNorm();
    const double sum = wa + wb + wc;
    // Degenerate triangles count as reached.
    return !(sum > 0.0) || !(2.0 * (wa * a + wb * b + wc * c).squaredNorm() > sum * squares);
}

// The three signed areas of p against the sides, seen along p's normal.
std::array<double, 3> side_areas(const SurfaceMesh& mesh, int triangle, const SurfacePoint& p) {
    Vec3 up = p.normal;
    if (!(up.squaredNorm() > 0.0)) {
        up = doubled_area(mesh, triangle);
    }
    std::array<double, 3> areas{};
    for (int i = 0; i < 3; ++i) {
        const Vec3& a = mesh.point_of(3 * triangle + i);
        const Vec3& b = mesh.point_of(SurfaceMesh::next(3 * triangle + i));
        areas[i] = (b - a).cross(p.point - a).dot(up);
    }
    return areas;
}

bool too_close(const SurfaceMesh& mesh, int triangle, const Vec3& p, double least) {
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if ((mesh.point_of(h) - p).norm() < least) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<Candidate> paper_site(const SurfaceMesh& mesh, int triangle, int& blocking_segment) {
    const Vec3& a = mesh.point_of(3 * triangle);
    const Vec3& b = mesh.point_of(3 * triangle + 1);
    const Vec3& c = mesh.point_of(3 * triangle + 2);
    const int obtuse = obtuse_vertex(a, b, c);
    if (obtuse < 0) {
        return weighted_site(mesh, triangle, circumcentre(a, b, c));
    }
    const int opposite = SurfaceMesh::next(3 * triangle + obtuse);
    blocking_segment = mesh.segment_of(opposite);
    if (blocking_segment >= 0) {
        return std::nullopt;
    }
    return weighted_site(mesh, SurfaceMesh::triangle_of(mesh.twin(opposite)), {{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}});
}

Candidate off_centre_site(const SurfaceMesh& mesh, int triangle, double angle) {
    const int h = shortest_side(mesh, triangle);
    const Vec3& a = mesh.point_of(h);
    const Vec3& b = mesh.point_of(SurfaceMesh::next(h));
    const Vec3& c = mesh.point_of(SurfaceMesh::prev(h));
    const Vec3 along = b - a;
    // Of the perpendicular bisector in the triangle's plane, towards the apex.
    Vec3 up = (c - a) - along * (along.dot(c - a) / along.squaredNorm());
    const double height = up.norm();
    Candidate result = edge_middle_site(mesh, h);
    if (!(height > 0.0)) {
        return result;  // no plane: the middle of the shortest edge is refused as crowded
    }
    const double half = 0.5 * along.norm();
    const double offset = along.dot(c - a) / along.squaredNorm() * along.norm() - half;
    const double centre = (height * height + offset * offset - half * half) / (2.0 * height);
    const double off_centre = half / std::tan(0.5 * kOffCentreSlack * angle);
    const double way = std::min(centre, off_centre);
    result.point += up * (way / height);
    result.reach = kMaxLift * way;
    result.uv_is_near = false;
    return result;
}

Candidate edge_middle_site(const SurfaceMesh& mesh, int h) {
    Weights w{{0.0, 0.0, 0.0}};
    w.w[h % 3] = 0.5;
    w.w[(h + 1) % 3] = 0.5;
    return weighted_site(mesh, SurfaceMesh::triangle_of(h), w);
}

std::optional<SurfacePoint> surface_point(const Workspace& work, const Candidate& candidate, const Answer& nearest) {
    if (!nearest.found() || nearest.distance > candidate.reach) {
        return std::nullopt;
    }
    return SurfacePoint{work.grid.snap(nearest.point), Vec2(nearest.u, nearest.v), nearest.normal};
}

namespace {

// Of a piece of the candidates, which the caches hold together with its questions and answers.
void add_surface_points(Workspace& work, const Candidate* first, const Candidate* last,
                        std::vector<std::optional<SurfacePoint>>& result) {
    geometry::Engine::Batch batch;
    batch.reserve(static_cast<std::size_t>(last - first));
    for (const Candidate* c = first; c != last; ++c) {
        batch.push_back(
            Query::face_nearest(work.mesh.face_of(c->triangle), work.grid.to_part(c->point), c->uv.x(), c->uv.y()));
    }
    geometry::Engine::Answers answers = work.session.ask(std::move(batch));
    Answer* answer = answers.data();
    for (const Candidate* c = first; c != last; ++c, ++answer) {
        if (c->uv_is_near && (!answer->found() || answer->distance > c->reach)) {
            *answer = work.session.ask(Query::face_point(work.mesh.face_of(c->triangle), c->uv.x(), c->uv.y()));
            answer->distance = (answer->point - work.grid.to_part(c->point)).norm();
        }
        result.push_back(surface_point(work, *c, *answer));
    }
}

}  // namespace

std::vector<std::optional<SurfacePoint>> surface_points(Workspace& work, const std::vector<Candidate>& candidates) {
    std::vector<std::optional<SurfacePoint>> result;
    result.reserve(candidates.size());
    for (std::size_t from = 0; from < candidates.size(); from += geometry::Session::kPiece) {
        const std::size_t to = std::min(from + geometry::Session::kPiece, candidates.size());
        add_surface_points(work, candidates.data() + from, candidates.data() + to, result);
    }
    return result;
}

Location locate(const SurfaceMesh& mesh, int triangle, const SurfacePoint& p) {
    int t = triangle;
    for (int step = 0; step < kMaxWalk; ++step) {
        const std::array<double, 3> areas = side_areas(mesh, t, p);
        const int least = static_cast<int>(std::min_element(areas.begin(), areas.end()) - areas.begin());
        const int h = 3 * t + least;
        const bool on_segment = mesh.segment_of(h) >= 0;
        if (areas[least] >= 0.0) {
            return {t, -1};
        }
        if (on_segment) {
            return {t, mesh.segment_of(h)};
        }
        t = SurfaceMesh::triangle_of(mesh.twin(h));
    }
    return {};
}

Surroundings look_around(const SurfaceMesh& mesh, int triangle, const Vec3& p) {
    Surroundings result;
    std::vector<int> queue{triangle};
    queue.reserve(32);
    for (std::size_t i = 0; i < queue.size() && queue.size() < kMaxVisit; ++i) {
        for (int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
            const int s = mesh.segment_of(h);
            result.nearest = std::min(result.nearest, (mesh.point_of(h) - p).norm());
            if (s >= 0) {
                if (encroached(mesh.point_of(h), mesh.point_of(SurfaceMesh::next(h)), p)) {
                    result.encroached.push_back(s);
                }
                continue;
            }
            const int other = SurfaceMesh::triangle_of(mesh.twin(h));
            if (std::find(queue.begin(), queue.end(), other) == queue.end() && in_circumsphere(mesh, other, p)) {
                queue.push_back(other);
            }
        }
    }
    result.triangles = std::move(queue);
    return result;
}

std::optional<Cause> insert_vertex(Workspace& work, int triangle, const SurfacePoint& p, std::vector<int>& touched,
                                   double aligned, std::optional<double> shortest) {
    SurfaceMesh& mesh = work.mesh;
    if (too_close(mesh, triangle, p.point, shortest.value_or(work.shortest_allowed()))) {
        return work.too_short();
    }
    const double least = std::min(aligned, alignment(mesh, triangle));
    const Cavity cavity = grow_cavity(mesh, 3 * triangle, false, {p.point, p.normal}, least);
    if (!cavity.complete) {
        return Cause::Fold;
    }
    const int face = mesh.face_of(triangle);
    const int site = mesh.add_site({mesh.add_vertex(p.point, {2, face}), p.uv, p.normal});
    const auto three = mesh.split_triangle(triangle, site);
    touched.insert(touched.end(), three.begin(), three.end());
    const std::size_t before = touched.size() - 3;
    for (const int g : cavity.outside) {
        work.maxmin.swap(g, touched);
    }
    work.maxmin.restore_around(before, touched);
    return std::nullopt;
}

}  // namespace mq::triangulate
